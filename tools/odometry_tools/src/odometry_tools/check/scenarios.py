"""The exercises, and the scenarios in which a node is judged."""

from typing import NamedTuple

GOAL = 2.0  # m
TARGET = 90.0  # degrees
PERIOD = 0.05  # s between two odometry messages, unless a scenario says otherwise


class Scenario(NamedTuple):
    """The conditions under which a node is judged."""

    name: str
    yaw: float = 0.0  # degrees, of the robot at the start
    place: tuple = (0.0, 0.0)  # of the robot at the start: x, y (m)
    odom_rate: float = 1 / PERIOD  # Hz
    speed_ratio: float = 1.0  # share of the commanded speed that the base reaches
    interrupt: bool = False  # whether to press Ctrl-C in mid-drive

    @property
    def start(self):
        """Where the robot starts: yaw and place."""
        return self.yaw, self.place


class Leg(NamedTuple):
    """A part of the route that the check drives for a detector."""

    name: str
    linear: float  # m/s
    angular: float  # rad/s
    duration: float  # s


class Exercise(NamedTuple):
    """A task for a learner's node."""

    name: str
    task: str
    topic: str  # that the node must publish
    type: str
    scenarios: tuple
    route: tuple = ()
    target: float = None  # degrees


ROUTE = (
    Leg('on the way out', 0.5, 0.0, 4.0),
    Leg('on the way back', -0.5, 0.0, 4.0),
    # As slowly as the tutorial's mover drives: a step of 5 mm must count, too.
    Leg('on an arc', 0.1, 0.31416, 5.0),
    Leg('on the rest of its circle', 0.1, 0.31416, 15.0),
    Leg('while spinning', 0.0, 1.5708, 2.0),
    Leg('while standing', 0.0, 0.0, 1.4))
SLOW = 0.7
PLAIN, INTERRUPT = Scenario('plain'), Scenario('interrupt', interrupt=True)
SLOW_ODOMETRY = Scenario('odom_5hz', odom_rate=5.0)
SLOW_BASE = Scenario('slow_base', speed_ratio=SLOW)
# From here each usual mistake ends somewhere else: one axis, the sum of both, the point (2, 0).
ELSEWHERE = 3.0, -1.2
COMMANDS = '/cmd_vel', 'geometry_msgs/Twist'
OBLIQUE = Scenario('moved_start', 130.0, ELSEWHERE)
EXERCISES = {exercise.name: exercise for exercise in (
    Exercise('moved_distance', 'publishes the distance moved', '/moved_distance',
             'std_msgs/Float64', (Scenario('route'), OBLIQUE, SLOW_ODOMETRY, SLOW_BASE),
             route=ROUTE),
    Exercise('two_meters', 'drives two metres and stops', *COMMANDS, (
        PLAIN, OBLIQUE, INTERRUPT, SLOW_ODOMETRY, SLOW_BASE)),
    # The shorter way is over 180 degrees from the first of these starts, over 0 from the second.
    Exercise('heading', 'turns to 90 degrees', *COMMANDS, (
        PLAIN, Scenario('moved_start', TARGET + 100, ELSEWHERE), INTERRUPT, SLOW_ODOMETRY,
        SLOW_BASE._replace(yaw=-45.0)), target=TARGET))}
