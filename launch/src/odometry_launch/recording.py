"""A bag and a picture of the run."""

import collections
import contextlib
import threading

import rosbag
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from std_msgs.msg import Float64

from odometry_launch.folders import new_folder
from odometry_launch.output import complain

TOPICS = {'odom': Odometry, 'base_pose_ground_truth': Odometry, 'moved_distance': Float64,
          'cmd_vel': Twist}


class Recording:
    """Records the robot's topics from its making to its end, or until the disk is full."""

    def __init__(self, runs):
        """Make a new folder for this moment in the folder `runs`; raise OSError if it cannot."""
        self.folder = new_folder(runs)
        self._file = (self.folder / 'run.bag').open('w+b')
        self._bag = rosbag.Bag(self._file, 'w')
        self._lock = threading.Lock()
        self._counts = collections.Counter()
        self._subscribers = {topic: rospy.Subscriber(topic, kind, self._keep, topic, tcp_nodelay=True)
                             for topic, kind in TOPICS.items()}

    def hears(self, *topics):
        """Return whether each of these topics has a publisher that is recorded."""
        return all(self._subscribers[topic].get_num_connections() for topic in topics)

    def count(self, topic):
        """Return how many messages of a topic have been recorded."""
        return self._counts[topic]

    def finish(self):
        """Close the bag and draw the picture; return its path, or None if it cannot be."""
        for subscriber in self._subscribers.values():
            subscriber.unregister()
        with self._lock:
            if self._bag:
                self._try(self._bag.close)
            if not self._bag:
                return None
            self._bag = None
        # matplotlib takes a second to import, which the start of the demo need not wait for.
        from odometry_launch.run_plot import BagError, make_figure, read_run
        picture = self.folder / 'run.png'
        try:
            make_figure(read_run(self.folder / 'run.bag')).savefig(str(picture))
        except (OSError, BagError) as error:
            complain(f'no picture: {error}')
            return None
        return picture

    def _keep(self, message, topic):
        now = rospy.get_rostime()
        with self._lock:
            if self._bag:
                self._try(lambda: self._bag.write(f'/{topic}', message, now))
            if self._bag:
                self._counts[topic] += 1

    def _try(self, write):
        """Write, or record no more."""
        try:
            write()
        except OSError as error:
            complain(f'the recording ends: {error}')
            with contextlib.suppress(OSError):
                self._bag.close()
            # What waits in its buffer cannot be written. Python 3.13 would complain of that.
            self._file.raw.close()
            self._bag = None
