"""What there is to see of each tutorial: its progress, its end, its result."""

import math

import rospy
from nav_msgs.msg import Odometry
from odometry_common.connections import hears
from odometry_common.geometry import wrap_to_pi, yaw_from_orientation
from std_msgs.msg import Float64

from odometry_launch.arrival import HEADING_TOLERANCE, has_driven, has_turned
from odometry_launch.options import in_lockstep
from odometry_launch.output import bar

ODOMETRY_PERIOD = 0.05  # s; the robot arrives between two odometries
BRAKING = 2.8  # m/s^2, measured on the simulated robot
AGREEMENT = 1e-3  # m and share of the distance; the path that is summed up is not quite straight


class ProgressMonitor:
    """Follows the robot's true motion from the world's origin; subclasses have arrived()."""

    def __init__(self):
        """Listen to the simulator."""
        self.ground_truth = None
        self.start = None
        self.end = None
        self._subscribers = []
        self._listen('base_pose_ground_truth', Odometry, self._on_ground_truth)

    def hears(self):
        """Return whether it hears the next message of everything that it listens to."""
        return all(map(hears, self._subscribers))

    @property
    def now(self):
        """Simulated seconds since the first message."""
        return (self.ground_truth.header.stamp - self.start.header.stamp).to_sec()

    @property
    def duration(self):
        """Simulated seconds from the first message until the robot had arrived."""
        return (self.end - self.start.header.stamp).to_sec()

    def _listen(self, topic, kind, callback):
        self._subscribers.append(rospy.Subscriber(topic, kind, callback, tcp_nodelay=True))

    def _on_ground_truth(self, message):
        self.ground_truth = message
        if self.start is None:
            self.start = message
        if self.end is None and self.arrived():
            self.end = message.header.stamp


class MoveMonitor(ProgressMonitor):
    """Follows the robot over two metres."""

    def __init__(self, options):
        """Listen to the detector too."""
        self._wanted = options.distance
        self._furthest = math.inf
        if in_lockstep(options):
            self._furthest = (self._wanted + abs(options.speed) * ODOMETRY_PERIOD
                              + options.speed**2 / (2 * BRAKING))
        self._moved = self._moved_before = 0.0
        super().__init__()
        self._listen('moved_distance', Float64, self._on_moved)

    def started(self):
        """Return whether the robot has begun to move."""
        return self.ground_truth is not None and self._moved > 0

    def arrived(self):
        """Return whether the distance is reached, and the robot stands by both accounts."""
        linear = self.ground_truth.twist.twist.linear
        return has_driven(self._moved, self._moved_before, self._wanted, (linear.x, linear.y))

    def progress(self):
        """Return one line."""
        speed = self.ground_truth.twist.twist.linear.x
        return (f'{bar(self._moved / self._wanted)} {self._moved:.2f} of {self._wanted:.2f} m, '
                f'{round(speed, 2) + 0.0:.2f} m/s, {self.now:.1f} s')

    def result(self):
        """Return the summary, and a complaint or None."""
        end = self.ground_truth.pose.pose.position
        true_distance = math.hypot(end.x, end.y)
        summary = (f'moved distance  {self._moved:.3f} m, summed from /odom\n'
                   f'true distance   {true_distance:.3f} m, in the simulated world')
        return summary, self._complaint(true_distance)

    def _complaint(self, true_distance):
        """Judge the robot; in real time how far it overshoots is up to the machine."""
        if not self._wanted <= self._moved <= self._furthest:
            return f'not between {self._wanted:.3f} and {self._furthest:.3f} m'
        if abs(self._moved - true_distance) > AGREEMENT * (1 + self._moved):
            return 'the two distances do not agree'
        return None

    def _on_moved(self, message):
        self._moved_before, self._moved = self._moved, message.data


class RotateMonitor(ProgressMonitor):
    """Follows the robot to a heading."""

    def __init__(self, options):
        """Listen to the odometry too, in whose frame the target is."""
        self._target = math.radians(options.target)
        self._yaw = None
        self._first_error = None
        super().__init__()
        self._listen('odom', Odometry, self._on_odometry)

    def started(self):
        """Return whether the heading is known."""
        return self.ground_truth is not None and self._yaw is not None

    def arrived(self):
        """Return whether the heading is reached and the robot hardly turns."""
        return self._yaw is not None and has_turned(
            wrap_to_pi(self._target - self._yaw), self.ground_truth.twist.twist.angular.z)

    def progress(self):
        """Return one line."""
        done = 1 - self._error() / self._first_error if self._first_error else 1.0
        return (f'{bar(done)} {math.degrees(self._yaw):.1f} degrees, '
                f'{self._error():.1f} to go, {self.now:.1f} s')

    def result(self):
        """Return the summary, and a complaint or None."""
        true_yaw = _yaw(self.ground_truth)
        true_error = abs(math.degrees(wrap_to_pi(true_yaw - self._target)))
        good = max(self._error(), true_error) <= HEADING_TOLERANCE + 0.01
        summary = (f'heading         {math.degrees(self._yaw):.2f} degrees, from /odom\n'
                   f'true turn       {math.degrees(true_yaw):.2f} degrees, in the simulated world')
        return summary, None if good else f'over {HEADING_TOLERANCE} degrees from the target'

    def _error(self):
        return abs(math.degrees(wrap_to_pi(self._target - self._yaw)))

    def _on_odometry(self, message):
        self._yaw = _yaw(message)
        if self._first_error is None:
            self._first_error = self._error()


def _yaw(message):
    return yaw_from_orientation(message.pose.pose.orientation)
