"""A robot without a mass, and nodes that are functions: what the check sees, in milliseconds."""

import math

from odometry_common.angles import wrap_to_pi
from odometry_tools.check.bench import Pace
from odometry_tools.check.endings import Drive, Route
from odometry_tools.check.judging import verdicts_on
from odometry_tools.check.run import Command, Pose, Run
from odometry_tools.check.scenarios import EXERCISES, PERIOD

WATCHDOG = 0.6  # s
FASTEST = 0.7, math.pi  # m/s, rad/s
LONGEST = 400.0  # s


class Robot:
    """Moves as the latest command says, until the watchdog stops it."""

    def __init__(self, scenario):
        """Stand where a Scenario begins."""
        self.x, self.y = scenario.place
        self.yaw = math.radians(scenario.yaw)
        self.time, self._ratio = 0.0, scenario.speed_ratio
        self._speed, self._until = (0.0, 0.0), 0.0

    def command(self, linear, angular):
        """Take a velocity (m/s, rad/s)."""
        self._speed = tuple(self._ratio * max(-most, min(most, speed))
                            for speed, most in zip((linear, angular), FASTEST))
        self._until = self.time + WATCHDOG

    def advance(self):
        """Move for a period."""
        if self.time > self._until:
            self._speed = 0.0, 0.0
        linear, angular = self._speed
        self.yaw = wrap_to_pi(self.yaw + angular * PERIOD / 2)
        self.x += linear * PERIOD * math.cos(self.yaw)
        self.y += linear * PERIOD * math.sin(self.yaw)
        self.yaw = wrap_to_pi(self.yaw + angular * PERIOD / 2)
        self.time += PERIOD

    def pose(self):
        """Return what odometry tells."""
        return Pose(self.time, self.x, self.y, self.yaw, *self._speed)


def drive(scenario, node, target):
    """Return the Run of a function that answers each Pose with a linear and an angular speed, or with None."""
    robot, run = Robot(scenario), Run(scenario, Pace(), Drive(target).is_over)
    _register(run)
    node = node()
    while not run.over:
        if on_time(robot, scenario):
            tell(run, robot)
            if (answer := node(robot.pose())) is not None:
                run.commands.append(Command(robot.time, *answer, (), 'cmd_vel'))
                robot.command(*answer)
        robot.advance()
    if scenario.interrupt:
        run.interrupted, run.interrupt_time = len(run.commands), run.now
        run.commands.append(Command(robot.time, 0.0, 0.0, (), 'cmd_vel'))
    return run


def drive_route(scenario, node):
    """Return the Run of a function that answers each Pose with a distance, or with None."""
    robot = Robot(scenario)
    run = Run(scenario, Pace(), Route(robot.command).is_over)
    _register(run)
    node = node()
    while not run.over:
        if on_time(robot, scenario):
            tell(run, robot)
            if (answer := node(robot.pose())) is not None:
                run.moved.append((robot.time, answer))
        robot.advance()
    return run


def tell(run, robot):
    """Have the check take the odometry."""
    with run.changed:
        run.take(robot.pose())


def on_time(robot, scenario):
    """Return whether odometry is sent now."""
    periods = round(robot.time / PERIOD)
    return periods % round(1 / scenario.odom_rate / PERIOD) == 0


def _register(run):
    run.nodes = {'/mine'}
    run.begin -= 1e3  # s of wall time, for which a node that is silent would be awaited
    run.subscribes = {'/odom': 'nav_msgs/Odometry'}


def verdicts(name, node, scenarios=None):
    """Return the Verdicts on a function in an exercise, by scenario."""
    exercise = EXERCISES[name]
    runs = [drive_route(scenario, node) if exercise.route else drive(scenario, node, exercise.target)
            for scenario in exercise.scenarios if scenarios is None or scenario.name in scenarios]
    found = verdicts_on(runs, exercise)
    return {verdict.scenario: verdict for verdict in found}
