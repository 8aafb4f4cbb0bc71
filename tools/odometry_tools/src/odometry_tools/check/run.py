"""The record of one scenario: messages and facts, in memory."""

import math
import threading
import time
from typing import NamedTuple

import rospy
from odometry_common.angles import wrap_to_pi
from odometry_common.orientation import yaw_from_orientation
from odometry_common.rest import is_slow
from sim_turtlebot.kobuki import MAX_ANGULAR_SPEED, MAX_LINEAR_SPEED

from odometry_tools.check.scenarios import PERIOD
from odometry_tools.runs.recording import ROBOT_TOPICS

SWING = 0.02  # rad/s; slower commands are noise of a settled controller
ZERO = 1e-3  # m/s, rad/s; slower commands count as zero
ALIKE = 0.03  # share, m or rad, by which two equal runs may differ
FASTER = 1.5  # times as fast as the base can move: that is a reset of odometry


class Pose(NamedTuple):
    """A message of odometry."""

    time: float  # s
    x: float  # m
    y: float  # m
    yaw: float  # rad
    linear: float  # m/s
    angular: float  # rad/s
    way: float = 0.0  # m driven so far
    turned: float = 0.0  # rad so far, either way
    turn: float = 0.0  # rad so far, to the left

    def after(self, before):
        """Return this with way and turns added to those of the Pose before; a reset adds none."""
        step = math.hypot(self.x - before.x, self.y - before.y)
        turn = wrap_to_pi(self.yaw - before.yaw)
        if self.has_jumped(before):
            step = turn = 0.0
        return self._replace(way=before.way + step, turned=before.turned + abs(turn),
                             turn=before.turn + turn)

    def has_jumped(self, before):
        """Return whether odometry was reset since the Pose before it."""
        duration = FASTER * max(self.time - before.time, PERIOD)
        return (math.hypot(self.x - before.x, self.y - before.y) > duration * MAX_LINEAR_SPEED
                or abs(wrap_to_pi(self.yaw - before.yaw)) > duration * MAX_ANGULAR_SPEED)


class Command(NamedTuple):
    """A Twist."""

    time: float  # s, to the nearest PERIOD
    linear: float  # m/s
    angular: float  # rad/s
    useless: tuple  # names of the other fields, if not zero
    topic: str

    @property
    def swings(self):
        """Whether it turns the robot faster than a settled controller does."""
        return abs(self.angular) > SWING

    @property
    def drives(self):
        """Whether it drives the robot, ahead or back."""
        return abs(self.linear) > ZERO

    @property
    def moves(self):
        """Whether it moves the robot."""
        return not (abs(self.linear) <= ZERO and abs(self.angular) <= ZERO)  # NaN is not zero


class Run:
    """Records a scenario until it is over."""

    def __init__(self, scenario, pace, is_over):
        """Record until `is_over`, a function of this Run, returns True."""
        self.scenario, self.pace, self._is_over = scenario, pace, is_over
        self.changed = threading.Condition()
        self.begin = None  # when time began (s of wall time); odometry before it is not of this run
        self.latest = -math.inf  # when the latest command came (monotonic, s)
        self.over = False
        self.odometry = []
        self.commands = []
        self.moved = []
        self.messages = []
        self.start = 0  # index of the first odometry after the last reset of it
        self.legs = []  # of the route: name, begin and end (s)
        self.unawaited = None  # why lockstep cannot wait for the node, if so
        self.interrupted = None  # number of commands before Ctrl-C
        self.interrupt_time = math.inf  # of Ctrl-C (s)
        self.ends = True  # whether Ctrl-C ends the node
        self.leaves_process = False  # whether a descendant survives Ctrl-C
        self.nodes = set()  # names of the learner's nodes
        self.has_begun = False  # whether it has called rospy.init_node
        self.publishes, self.subscribes = {}, {}  # types by topic; '' if it is not known
        self.links = set()  # by which the node sent to the check as time began
        self.refuses = False  # whether it has closed one of these
        self.is_cpp = False
        self.has_read_keyboard = False
        self.follows_wall = False  # whether a second run differed
        self.has_lost_message = False  # whether an earlier run lacked its last one
        self.status, self.output = None, ''  # exit status, if it has ended by itself

    def __getstate__(self):
        """Leave out what cannot be sent to another process."""
        return {name: value for name, value in vars(self).items()
                if name not in ('changed', '_is_over')}

    @property
    def now(self):
        """Simulated time (s) of the latest odometry."""
        return self.odometry[-1].time if self.odometry else 0.0

    @property
    def is_conclusive(self):
        """Whether other scenarios would end like it: it never began, or refuses to send."""
        sends_nothing = not (self.commands or self.moved)
        return not self.odometry or self.refuses and sends_nothing

    @property
    def first_move(self):
        """When the node first commanded a movement (s), or None."""
        return next((command.time for command in self.commands if command.moves), None)

    @property
    def is_driving(self):
        """Whether the robot moves, and its last command is not zero."""
        return (bool(self.commands and self.odometry) and self.commands[-1].moves
                and not is_slow(self.odometry[-1].linear, self.odometry[-1].angular))

    def add(self, topic, message):
        """Record a message."""
        with self.changed:
            if (self.over or message._connection_header.get('callerid') == rospy.get_name()
                    or self.begin is None and topic in ROBOT_TOPICS):
                return
            now = rospy.get_rostime()
            self.messages.append((topic, message, now))
            getattr(self, f'_on_{type(message).__name__.lower()}')(topic, message, now.to_sec())

    def finish(self, over=True, **facts):
        """Set facts and `over`, after which nothing is recorded; wake the main thread."""
        with self.changed:
            vars(self).update(facts, over=over)
            self.changed.notify_all()

    def _on_odometry(self, topic, message, _now):
        if topic != 'odom':
            return
        pose, twist = message.pose.pose, message.twist.twist
        self.take(Pose(message.header.stamp.to_sec(), pose.position.x, pose.position.y,
                       yaw_from_orientation(pose.orientation), twist.linear.x, twist.angular.z))

    def take(self, pose):
        """Record a Pose from odometry, and test whether the scenario is over."""
        if self.odometry:
            before = self.odometry[-1]
            if pose.has_jumped(before):
                self.start = len(self.odometry)
            pose = pose.after(before)
        self.odometry.append(pose)
        if self.interrupted is None and self._is_over(self):
            self.over = True
            self.changed.notify_all()

    def _on_twist(self, topic, message, now):
        # Messages of one tick arrive in any order, so the clock may be one tick late.
        now = round(now / PERIOD) * PERIOD
        self.latest = time.monotonic()
        useless = tuple(f'{part}.{axis}' for part, axes in (('linear', 'yz'), ('angular', 'xy'))
                        for axis in axes if not abs(getattr(getattr(message, part), axis)) <= ZERO)
        self.commands.append(Command(now, message.linear.x, message.angular.z, useless, topic))

    def _on_float64(self, _topic, message, _now):
        self.moved.append((self.now, message.data))

    def wall_time(self):
        """Return the wall time (s) since simulated time began."""
        return time.monotonic() - self.begin

    def is_like(self, other):
        """Return whether another Run ended like this; the order of threads may matter a little."""
        return all(math.isclose(mine, others, rel_tol=ALIKE, abs_tol=ALIKE)
                   for mine, others in zip(self._outcome(), other._outcome()))

    def _outcome(self):
        counted = self.moved[-1][1] if self.moved else 0.0
        return self.odometry[-1].way, self.odometry[-1].turned, counted
