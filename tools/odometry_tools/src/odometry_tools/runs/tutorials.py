"""The tutorials' loops over odometry, without ROS: progress, arrival and metrics of a robot."""

import math

from geometry_msgs.msg import Quaternion
from heading_control import turn
from moved_distance import distance_counter
from odometry_common.angles import wrap_to_pi
from odometry_common.orientation import yaw_from_orientation
from odometry_common.rest import is_slow
from sim_turtlebot.geometry import PlanarPose, is_upright
from sim_turtlebot.kobuki import MAX_ANGULAR_SPEED, MAX_LINEAR_SPEED
from sim_turtlebot.robot.odometry import Motion
from straight_drive import drive

from odometry_tools.runs.rate import Rate

ARRIVED, LATE, FALLEN = 'arrived', 'late', 'fallen'  # why a run ended
# A run is late after 1.5 times the time that a perfect robot takes, plus 10 s.
TIMEOUT_FACTOR, TIMEOUT_MARGIN = 1.5, 10.0
REST_STEP = 1e-5  # m between two odometries
HEADING_TOLERANCE = 0.1  # degrees


class Move:
    """The first tutorial: the detector and the mover."""

    PARAMETERS = (*distance_counter.PARAMETERS.rows, *drive.PARAMETERS.rows)

    def __init__(self, values):
        self._counter = distance_counter.DistanceCounter(
            **vars(distance_counter.PARAMETERS.read(values)))
        parameters = drive.PARAMETERS.read(values)
        self._drive = drive.Drive(parameters.distance, parameters.speed, parameters.relative)
        self.targets = {'distance_target': parameters.distance}  # for the picture of the run
        speed = min(abs(self._drive.speed), MAX_LINEAR_SPEED)
        self.timeout = TIMEOUT_FACTOR * self._drive.distance / speed + TIMEOUT_MARGIN

    def answer(self, stamp, odometry, ground_truth):
        """Return the command (m/s, rad/s) for an odometry, and whether the robot has arrived.

        :param stamp: s
        :param odometry, ground_truth: Motions
        """
        moved_before = self._counter.distance
        x, y, _ = odometry.position
        self._counter.add(x, y, stamp, stamp)
        moved = self._counter.distance
        self._speed = ground_truth.linear[0]
        arrived = (moved >= self._drive.distance and moved - moved_before < REST_STEP
                   and is_slow(math.hypot(*ground_truth.linear[:2])))
        return (self._drive.speed_at(moved), 0.0), arrived

    def progress(self):
        """Return the share that is done (0 to 1), and words for the state."""
        moved, wanted = self._counter.distance, self._drive.distance
        speed = round(self._speed, 2) + 0.0  # not -0.0
        return moved / wanted, f'{moved:.2f} of {wanted:.2f} m, {speed:.2f} m/s'

    def metrics(self, start, end):
        """Return the metrics by name, without time, from the true first and last Motion."""
        moved, wanted = self._counter.distance, self._drive.distance
        poses = [PlanarPose(*motion.position[:2], _yaw(motion)) for motion in (start, end)]
        travel = poses[0].inverse().then(poses[1])
        true_distance = math.hypot(travel.x, travel.y)
        return {
            'moved': moved,
            'moved_error': moved - wanted,
            'true_distance': true_distance,
            'true_error': true_distance - wanted,
            'sideways': travel.y,
            'heading': degrees(travel.yaw)}


class Rotate:
    """The second tutorial: the P-controller on the heading."""

    PARAMETERS = turn.PARAMETERS.rows

    def __init__(self, values):
        parameters = turn.PARAMETERS.read(values)
        self._turn = turn.Turn(parameters.target, parameters.kp, parameters.max_angular_speed)
        self.targets = {'heading_target': parameters.target}
        self._loop = Rate(parameters.rate)
        self._overshoot = 0.0
        self._first_error = None
        # The robot turns at full speed, then slows down exponentially near the target.
        angle = abs(self._turn.error_at(0.0))
        turning = angle / min(self._turn.max_angular_speed, MAX_ANGULAR_SPEED)
        slowing = math.log(max(1.0, math.degrees(angle) / HEADING_TOLERANCE)) / self._turn.kp
        self.timeout = TIMEOUT_FACTOR * (turning + slowing) + TIMEOUT_MARGIN

    def answer(self, stamp, odometry, ground_truth):
        """Return what Move.answer() returns; the command is None if none is due."""
        self._yaw = _yaw(odometry)
        self._error = self._turn.error_at(self._yaw)
        if self._first_error is None:
            self._first_error = self._error
        beyond = -math.copysign(1.0, self._first_error) * self._error
        if beyond < math.pi / 2:  # farther off, the error changes sign behind the robot
            self._overshoot = max(self._overshoot, beyond)
        is_due = self._loop.is_due(round(stamp * 1e9))
        command = (0.0, self._turn.speed_for(self._error)) if is_due else None
        arrived = (abs(math.degrees(self._error)) <= HEADING_TOLERANCE
                   and is_slow(0.0, ground_truth.angular[2]))
        return command, arrived

    def progress(self):
        """Return what Move.progress() returns."""
        error = abs(self._error)
        share = 1 - error / abs(self._first_error) if self._first_error else 1.0
        return share, f'{degrees(self._yaw):.1f} degrees, {math.degrees(error):.1f} to go'

    def metrics(self, start, end):
        """Return the metrics by name, without time, from the true first and last Motion."""
        true_yaw = _yaw(end) - _yaw(start)
        return {
            'heading': degrees(self._yaw),
            'heading_error': math.degrees(-self._error),
            'true_heading': degrees(true_yaw),
            'true_error': math.degrees(-self._turn.error_at(true_yaw)),
            'overshoot': math.degrees(self._overshoot)}


TUTORIALS = {'move': Move, 'rotate': Rotate}


def follow(loop, ticks, command):
    """Feed each odometry to a tutorial's loop until the run ends; return the metrics.

    :param ticks: yields the stamp of each odometry (s, as in rospy) and two Motions, by odometry
        and the true one
    :param command: called with each command, m/s and rad/s
    """
    start = None
    for stamp, odometry, ground_truth in ticks:
        start = start or ground_truth
        answer, arrived = loop.answer(stamp, odometry, ground_truth)
        if answer:
            command(*answer)
        if arrived or stamp > loop.timeout:
            break
    upright = is_upright(ground_truth.orientation)
    ended = ARRIVED if arrived else LATE if upright else FALLEN
    return {**loop.metrics(start, ground_truth), 'time': stamp, 'ended': ended}


def motion_in(message):
    """Return the Motion in a nav_msgs/Odometry."""
    pose, twist = message.pose.pose, message.twist.twist
    return Motion(*(tuple(getattr(part, name) for name in part.__slots__) for part in (
        pose.position, pose.orientation, twist.linear, twist.angular)))


def _yaw(motion):
    return yaw_from_orientation(Quaternion(*motion.orientation))


def degrees(angle):
    """Return an angle (rad) in degrees, from -180 to 180."""
    return math.degrees(wrap_to_pi(angle))
