"""A tutorial's loop in one process, bit-identical to the nodes in lockstep."""

import functools
import math
import threading

from geometry_msgs.msg import Quaternion
from heading_control import turn
from moved_distance import distance_counter
from odometry_common.angles import wrap_to_pi
from odometry_common.orientation import yaw_from_orientation
from sim_turtlebot.geometry import PlanarPose, is_upright
from sim_turtlebot.kobuki import MAX_ANGULAR_SPEED, MAX_LINEAR_SPEED
from sim_turtlebot.physics.world import World
from sim_turtlebot.settings import read_settings
from sim_turtlebot.simulation import Simulation
from straight_drive import drive

from odometry_tools.runs.arrival import HEADING_TOLERANCE, has_turned, is_at_rest
from odometry_tools.sweep.rate import Rate

ARRIVED, LATE, FALLEN = 'arrived', 'late', 'fallen'  # why a run ended
UNTIL = 'until'  # of nodes that go on for ever
# A run is late after 1.5 times the time that a perfect robot takes, plus 10 s.
TIMEOUT_FACTOR, TIMEOUT_MARGIN = 1.5, 10.0

# A Dask worker has several threads, but PyBullet and its world belong to the process.
_run_lock = threading.Lock()


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
        arrived = (moved >= self._drive.distance
                   and is_at_rest(moved - moved_before, ground_truth.linear))
        return (self._drive.speed_at(moved), 0.0), arrived

    def metrics(self, start, end):
        """Return the metrics by name, without time, from the true first and last Motion."""
        moved, wanted = self._counter.distance, self._drive.distance
        poses = [PlanarPose(*motion.position[:2], _yaw(motion)) for motion in (start, end)]
        travel = poses[0].inverse().then(poses[1])
        true_distance = math.hypot(travel.x, travel.y)
        return {'moved': moved, 'moved_error': moved - wanted,
                'true_distance': true_distance, 'true_error': true_distance - wanted,
                'sideways': travel.y, 'heading': degrees(travel.yaw)}


class Rotate:
    """The second tutorial: the P-controller on the heading."""

    PARAMETERS = turn.PARAMETERS.rows

    def __init__(self, values):
        parameters = turn.PARAMETERS.read(values)
        self._turn = turn.Turn(parameters.target, parameters.kp, parameters.max_angular_speed)
        self.targets = {'heading_target': parameters.target}
        self._loop = Rate(parameters.rate)
        self._overshoot = 0.0
        self._direction = None
        # The robot turns at full speed, then slows down exponentially near the target.
        angle = abs(self._turn.error_at(0.0))
        turning = angle / min(self._turn.max_angular_speed, MAX_ANGULAR_SPEED)
        slowing = math.log(max(1.0, math.degrees(angle) / HEADING_TOLERANCE)) / self._turn.kp
        self.timeout = TIMEOUT_FACTOR * (turning + slowing) + TIMEOUT_MARGIN

    def answer(self, stamp, odometry, ground_truth):
        """Return what Move.answer() returns; the command is None if none is due."""
        self._yaw = _yaw(odometry)
        self._error = self._turn.error_at(self._yaw)
        if self._direction is None:
            self._direction = math.copysign(1.0, self._error)
        beyond = -self._direction * self._error
        if beyond < math.pi / 2:  # farther off, the error changes sign behind the robot
            self._overshoot = max(self._overshoot, beyond)
        is_due = self._loop.is_due(round(stamp * 1e9))
        command = (0.0, self._turn.speed_for(self._error)) if is_due else None
        return command, has_turned(self._error, ground_truth.angular[2])

    def metrics(self, start, end):
        """Return the metrics by name, without time, from the true first and last Motion."""
        true_yaw = _yaw(end) - _yaw(start)
        return {'heading': degrees(self._yaw), 'heading_error': math.degrees(-self._error),
                'true_heading': degrees(true_yaw),
                'true_error': math.degrees(-self._turn.error_at(true_yaw)),
                'overshoot': math.degrees(self._overshoot)}


TUTORIALS = {'move': Move, 'rotate': Rotate}


def run(tutorial, parameters):
    """Run a tutorial with parameter values by name; return its metrics by name."""
    with _run_lock:
        loop, settings = TUTORIALS[tutorial](parameters), read_settings(parameters)
        settings.clock_rate = settings.odom_rate  # as for the nodes
        simulation = Simulation(settings, build_world=_world)
        return follow(loop, _ticks(simulation), simulation.command)


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


def _ticks(simulation):
    robot, timeline = simulation.robots[0], simulation.timeline
    while True:
        seconds, nanoseconds = divmod(timeline.now, 10**9)
        yield seconds + nanoseconds / 1e9, robot.odometry, robot.ground_truth
        while not simulation.advance():
            pass


_cached_world = functools.lru_cache(maxsize=1)(World)


def _world(step_rate, starts, gui, world_file):
    """Return a World whose robots are at their starts; reuse that of the last run if possible.

    Building one takes a tenth as long as a drive of two metres. In a world with a file, other
    things may have moved, too.
    """
    world = _cached_world(step_rate, tuple(starts), gui, world_file)
    (world.rebuild if world_file else world.restart)()
    return world


def _yaw(motion):
    return yaw_from_orientation(Quaternion(*motion.orientation))


def degrees(angle):
    """Return an angle (rad) in degrees, from -180 to 180."""
    return math.degrees(wrap_to_pi(angle))
