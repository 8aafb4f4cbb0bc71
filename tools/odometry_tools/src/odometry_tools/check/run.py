"""What happens in one scenario, in memory."""

import threading
import time
from typing import NamedTuple

import rospy
from odometry_common.angles import wrap_to_pi
from odometry_common.orientation import yaw_from_orientation

from odometry_tools.check.scenarios import PERIOD
from odometry_tools.runs.session import UNAWAITED

ZERO = 1e-3  # m/s, rad/s; a slower command is none


class Pose(NamedTuple):
    """A message of odometry."""

    time: float  # s
    x: float  # m
    y: float  # m
    yaw: float  # rad, without jumps
    linear: float  # m/s
    angular: float  # rad/s


class Command(NamedTuple):
    """A Twist."""

    time: float  # s, to the nearest PERIOD
    linear: float  # m/s
    angular: float  # rad/s
    useless: tuple  # names of the other fields that are not zero
    topic: str

    @property
    def moves(self):
        """Whether the robot should move."""
        return abs(self.linear) > ZERO or abs(self.angular) > ZERO


class Run:
    """A scenario as it goes: what the topics show, until it is over."""

    def __init__(self, scenario, pace, is_over):
        """Record until a function of this Run says that it is over."""
        self.scenario, self.pace, self._is_over = scenario, pace, is_over
        self.changed = threading.Condition()
        self.begin = time.monotonic()  # when time began (s of wall time)
        self.over = False
        self.odometry, self.commands, self.moved, self.messages = [], [], [], []
        self.legs = []  # of the route: name, begin and end (s)
        self.sent = 0  # commands; of a flood, `commands` has the latest
        self.unawaited = None  # why lockstep does not wait for the node
        self.interrupted = None  # index of the command after Ctrl-C
        self.ends = True  # whether Ctrl-C ends the node
        # What the nodes that the learner's process contains have announced to the master.
        self.nodes, self.publishes, self.subscribes = set(), set(), set()
        self.types, self.published = {}, set()  # of all topics; topics that anybody publishes
        self.forked = False  # whether its process has ended, and another that it started goes on
        self.refused = set()  # topics whose publisher takes no connection
        self.walls = []  # s of wall time of the commands
        self.status, self.output = None, ''  # exit status, if it has ended by itself

    @property
    def now(self):
        """Simulated time (s) of the latest odometry."""
        return self.odometry[-1].time if self.odometry else 0.0

    @property
    def first_move(self):
        """When the node first commanded a movement (s), or None."""
        return next((command.time for command in self.commands if command.moves), None)

    @property
    def is_driving(self):
        """Whether the robot moves, as it was told."""
        return bool(self.commands and self.odometry) and self.commands[-1].moves and max(
            abs(self.odometry[-1].linear), abs(self.odometry[-1].angular)) > ZERO

    def add(self, topic, message):
        """Take a message."""
        with self.changed:
            if self.over or message._connection_header.get('callerid') == rospy.get_name():
                return
            now = rospy.get_rostime()
            self.messages.append((topic, message, now))
            getattr(self, f'_on_{type(message).__name__.lower()}')(topic, message, now.to_sec())

    def finish(self, over=True, **facts):
        """Set attributes, record nothing more unless it is not over, and have the main thread look."""
        with self.changed:
            vars(self).update(facts, over=over)
            self.changed.notify_all()

    def _on_odometry(self, topic, message, _now):
        if topic != 'odom':
            return
        pose, twist = message.pose.pose, message.twist.twist
        yaw = yaw_from_orientation(pose.orientation)
        if self.odometry:
            yaw = self.odometry[-1].yaw + wrap_to_pi(yaw - self.odometry[-1].yaw)
        self.odometry.append(Pose(message.header.stamp.to_sec(), pose.position.x, pose.position.y, yaw,
                                  twist.linear.x, twist.angular.z))
        if self.interrupted is None and self._is_over(self):
            self.over = True
            self.changed.notify_all()

    def _on_twist(self, topic, message, now):
        # Messages of one tick arrive in any order: to the millisecond, the tick before may be meant.
        now = round(now / PERIOD) * PERIOD
        useless = tuple(f'{part}.{axis}' for part, axes in (('linear', 'yz'), ('angular', 'xy'))
                        for axis in axes if abs(getattr(getattr(message, part), axis)) > ZERO)
        self.walls.append(time.monotonic())
        self.commands.append(Command(now, message.linear.x, message.angular.z, useless, topic))

    def _on_float64(self, _topic, message, _now):
        self.moved.append((self.now, message.data))

    def note_log(self, text, ours):
        """Notice what the simulator says of a node, unless it is one of ours."""
        found = UNAWAITED.match(text)
        if found and found[1] not in ours and not self.over:
            self.finish(unawaited=found[2])

    def wall_time(self):
        """Return the seconds of wall time since time began."""
        return time.monotonic() - self.begin
