"""Record a run in a bag, and draw its picture."""

import contextlib
import math
import os
import threading
import time

import rosbag
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from odometry_common.connections import is_connected
from std_msgs.msg import Float64

from odometry_tools.runs.figure import make_figure
from odometry_tools.runs.folders import new_folder, path_in_errors
from odometry_tools.runs.output import complain
from odometry_tools.runs.recorded_run import COMMANDS, BagError, read_run

ROBOT_TOPICS = 'odom', 'base_pose_ground_truth'
TOPICS = {**dict.fromkeys(ROBOT_TOPICS, Odometry), 'moved_distance': Float64,
          **dict.fromkeys(COMMANDS, Twist)}


class Recording:
    """Records the robot's topics until close(), or until the disk is full.

    OSError: the folder cannot be made.
    """

    def __init__(self, folder=None):
        """Record in a folder (a Path); None: in a new one."""
        self.path = (folder or new_folder()) / 'run.bag'
        self._file = self.path.open('w+b')
        self._bag = rosbag.Bag(self._file, 'w')
        self._lock = threading.Lock()
        self._heard = {}  # when the last message of a node came (monotonic, s), by name
        self._subscribers = {
            topic: rospy.Subscriber(topic, kind, self._keep, topic, tcp_nodelay=True)
            for topic, kind in TOPICS.items()}

    def is_connected(self, *topics):
        """Return whether the recording receives the next message of each of these topics."""
        return all(is_connected(self._subscribers[topic]) for topic in topics)

    def heard_since(self, moment):
        """Return the names of the nodes whose messages have come since a moment (monotonic, s)."""
        with self._lock:
            return {name.lstrip('/') for name, last in self._heard.items() if last > moment}

    def close(self):
        """Close the bag; return its path, or None if it is incomplete."""
        for subscriber in self._subscribers.values():
            subscriber.unregister()
        return self.close_bag()

    def close_bag(self):
        """As close(), but without the master, which may be suspended."""
        with self._lock:
            if self._bag:
                self._try(self._bag.close)
            if not self._bag:
                return None
            self._bag = None
        return self.path

    def _keep(self, message, topic):
        now = rospy.get_rostime()
        with self._lock:
            self._heard[message._connection_header.get('callerid', '')] = time.monotonic()
            if self._bag:
                self._try(lambda: self._bag.write(f'/{topic}', message, now))

    def _try(self, write):
        """Write, or stop recording."""
        try:
            write()
        except OSError as error:
            complain(f'the recording ends: {error}')
            with contextlib.suppress(OSError):
                self._bag.close()
            # Otherwise Python 3.13 reports that it cannot write the buffer.
            self._file.raw.close()
            self._bag = None


def leave_picture(bag, end=math.inf, **targets):
    """Draw the run in a bag (a Path); print the path of the picture, or why there is none.

    :param end: of the run (s)
    :param targets: as for make_figure()
    """
    picture = bag.with_suffix('.png')
    try:
        with path_in_errors(picture):
            make_figure(read_run(bag, end=end), **targets).savefig(str(picture))
    except (OSError, BagError) as error:
        complain(f'no picture: {error}')
    else:
        print(f'picture         {os.path.relpath(picture)}', flush=True)
