"""Progress, completion and result of each tutorial."""

import math
import threading
from functools import partial

import rospy
from nav_msgs.msg import Odometry
from odometry_common.angles import wrap_to_pi
from odometry_common.connections import is_connected
from odometry_common.orientation import yaw_from_orientation
from std_msgs.msg import Float64

from odometry_tools.runs.arrival import HEADING_TOLERANCE, REST_STEP, has_turned, is_at_rest
from odometry_tools.runs.output import bar

MAX_DIFFERENCE = 1e-3  # m, and share of the distance; the summed path is not quite straight


class ProgressMonitor:
    """Follows the robot's true motion from the world's origin until it arrives.

    The result depends only on the motion, even if messages of a topic arrive late.
    """

    def __init__(self):
        self.ground_truth = None
        self.start = None
        self.end = None
        self._subscribers = []
        self._lock = threading.Lock()

    def is_connected(self):
        """Return whether it receives the next message on each of its topics."""
        return all(map(is_connected, self._subscribers))

    @property
    def now(self):
        """Simulated seconds since the first message, until the robot arrives."""
        return (self.ground_truth.header.stamp - self.start.header.stamp).to_sec()

    def _subscribe(self, topic, kind, callback):
        """Call a function with each message on a topic until the robot arrives."""
        def receive(message):
            with self._lock:
                if self.end is None:
                    callback(message)

        self._subscribers.append(rospy.Subscriber(topic, kind, receive, tcp_nodelay=True))

    def _follow(self, ground_truth):
        self.start = self.start or ground_truth
        self.ground_truth = ground_truth

    def _arrive(self, ground_truth):
        self.ground_truth = ground_truth
        self.end = ground_truth.header.stamp


class MoveMonitor(ProgressMonitor):
    """Follows the robot over two metres."""

    def __init__(self, options):
        self._wanted = options.distance
        self._moved = 0.0
        self._is_final = False  # the target is reached, and the distance no longer grows
        self._has_moved = False
        self._rest = None  # the first message of a robot that is at rest again
        super().__init__()
        self._subscribe('base_pose_ground_truth', Odometry, self._on_ground_truth)
        self._subscribe('moved_distance', Float64, self._on_moved)

    def started(self):
        """Return whether the robot has begun to move."""
        return self.ground_truth is not None and self._moved > 0

    def progress(self):
        """Return a line of progress."""
        speed = self.ground_truth.twist.twist.linear.x
        return (f'{bar(self._moved / self._wanted)} {self._moved:.2f} of {self._wanted:.2f} m, '
                f'{round(speed, 2) + 0.0:.2f} m/s, {self.now:.1f} s')

    def result(self):
        """Return the summary, and an error message or None."""
        end = self.ground_truth.pose.pose.position
        true_distance = math.hypot(end.x, end.y)
        summary = (f'moved distance  {self._moved:.3f} m, summed from /odom\n'
                   f'true distance   {true_distance:.3f} m, in the simulated world')
        differs = abs(self._moved - true_distance) > MAX_DIFFERENCE * (1 + self._moved)
        return summary, 'the two distances do not agree' if differs else None

    def _on_ground_truth(self, message):
        before = (self.ground_truth or message).pose.pose.position
        position, linear = message.pose.pose.position, message.twist.twist.linear
        step = math.hypot(position.x - before.x, position.y - before.y)
        self._follow(message)
        if not is_at_rest(step, (linear.x, linear.y)):
            self._has_moved, self._rest = True, None
        elif self._has_moved and self._rest is None:
            self._rest = message
        self._check_arrival()

    def _on_moved(self, message):
        before, self._moved = self._moved, message.data
        self._is_final = self._moved >= self._wanted and self._moved - before < REST_STEP
        self._check_arrival()

    def _check_arrival(self):
        """Arrive once both topics show the robot at rest."""
        if self._rest is not None and self._is_final:
            self._arrive(self._rest)


class RotateMonitor(ProgressMonitor):
    """Follows the robot to a heading."""

    def __init__(self, options):
        self._target = math.radians(options.target)
        self._yaw = None
        self._first_error = None
        self._pairs = {}  # messages by stamp and topic, until both have arrived
        super().__init__()
        for topic in 'odom', 'base_pose_ground_truth':
            self._subscribe(topic, Odometry, partial(self._on_message, topic))

    def started(self):
        """Return whether the heading is known."""
        return self.ground_truth is not None

    def progress(self):
        """Return a line of progress."""
        done = 1 - self._error() / self._first_error if self._first_error else 1.0
        return (f'{bar(done)} {math.degrees(self._yaw):.1f} degrees, '
                f'{self._error():.1f} to go, {self.now:.1f} s')

    def result(self):
        """Return the summary, and an error message or None."""
        true_yaw = _yaw(self.ground_truth)
        true_error = abs(math.degrees(wrap_to_pi(true_yaw - self._target)))
        good = max(self._error(), true_error) <= HEADING_TOLERANCE + 0.01
        summary = (f'heading         {math.degrees(self._yaw):.2f} degrees, from /odom\n'
                   f'true turn       {math.degrees(true_yaw):.2f} degrees, in the simulated world')
        return summary, None if good else f'over {HEADING_TOLERANCE} degrees from the target'

    def _error(self):
        return abs(math.degrees(wrap_to_pi(self._target - self._yaw)))

    def _on_message(self, topic, message):
        """Wait for both messages of a stamp."""
        stamp = message.header.stamp.to_nsec()
        pair = self._pairs.setdefault(stamp, {})
        pair[topic] = message
        if len(pair) == 2:
            del self._pairs[stamp]
            self._on_pair(**pair)

    def _on_pair(self, odom, base_pose_ground_truth):
        """Arrive once the robot has reached the heading and hardly turns."""
        self._yaw = _yaw(odom)
        if self._first_error is None:
            self._first_error = self._error()
        self._follow(base_pose_ground_truth)
        if has_turned(wrap_to_pi(self._target - self._yaw),
                      base_pose_ground_truth.twist.twist.angular.z):
            self._arrive(base_pose_ground_truth)


def _yaw(message):
    return yaw_from_orientation(message.pose.pose.orientation)
