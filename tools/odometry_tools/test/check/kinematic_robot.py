"""A robot without a mass, and nodes that are functions: what the check sees, in milliseconds."""

import math

from odometry_common.angles import wrap_to_pi
from odometry_tools.check.check_session import Pace
from odometry_tools.check.endings import Drive, Route
from odometry_tools.check.judging import verdicts_on
from odometry_tools.check.run import Command, Pose, Run
from odometry_tools.check.scenarios import EXERCISES, PERIOD

TWO_METERS = EXERCISES['two_meters']
PLAIN = TWO_METERS.scenarios[0]
WATCHDOG = 0.6  # s
FASTEST = 0.7, math.pi  # m/s, rad/s


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
        self.x += linear * PERIOD * math.cos(self.yaw)
        self.y += linear * PERIOD * math.sin(self.yaw)
        self.yaw = wrap_to_pi(self.yaw + angular * PERIOD)
        self.time += PERIOD

    def pose(self):
        """Return what odometry tells."""
        return Pose(self.time, self.x, self.y, self.yaw, *self._speed)


def drive(node, scenario=PLAIN, exercise=TWO_METERS):
    """Return the Run of a function that answers each Pose with a linear and an angular speed, or with None.

    On a route it answers with a distance, or with None.
    """
    robot, node = Robot(scenario), node()
    ending = Route(robot.command) if exercise.route else Drive(target=exercise.target)
    run = Run(scenario, Pace(), ending.is_over)
    run.nodes = {'/mine'}
    run.begin = -math.inf  # s of wall time; nobody waits for a node that is silent
    run.subscribes = {'/odom': 'nav_msgs/Odometry'}
    periods = 0
    while not run.over:
        if periods % round(1 / scenario.odom_rate / PERIOD) == 0:
            with run.changed:
                run.take(robot.pose())
            answer = node(robot.pose())
            if answer is not None and exercise.route:
                run.moved.append((robot.time, answer))
            elif answer is not None:
                run.commands.append(Command(robot.time, *answer, (), 'cmd_vel'))
                robot.command(*answer)
        robot.advance()
        periods += 1
    if scenario.interrupt:
        run.interrupted, run.interrupt_time = len(run.commands), run.now
        run.commands.append(Command(robot.time, 0.0, 0.0, (), 'cmd_vel'))
    return run


def verdict_on(run):
    """Return the Verdict on a Run of two metres."""
    return verdicts_on([run], TWO_METERS)[0]


def verdicts(exercise, node):
    """Return the Verdicts on a function in an exercise, by scenario."""
    runs = [drive(node, scenario, exercise) for scenario in exercise.scenarios]
    return {verdict.scenario: verdict for verdict in verdicts_on(runs, exercise)}
