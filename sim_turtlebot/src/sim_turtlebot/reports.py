"""Log lines and ~warning about robots that fall or stop, and about the pace."""

import math
import time

import rospy
from std_msgs.msg import String

from sim_turtlebot.geometry import is_upright

TIMEOUT_LINE_PERIOD = 10.0  # s of wall time


class Reports:
    """Reports robots that fell or were stopped by watchdogs, and a simulation that is too slow."""

    def __init__(self, robots, settings):
        """Take the robots, all upright."""
        self._robots, self._settings = robots, settings
        self._fallen = set()  # robots
        self._timeout_lines = {}  # when the last such line was written (monotonic, s), by robot
        self._publisher = rospy.Publisher('~warning', String, queue_size=10, latch=True)
        self._warnings = {}  # texts by cause
        self.warn('', '')

    def warn(self, cause, text):
        """Publish a warning beside those of other causes; an empty text withdraws it."""
        self._warnings.pop(cause, None)
        if text:
            self._warnings[cause] = text
        self._publisher.publish('; '.join(self._warnings.values()))

    def pace(self, reached):
        """Report that the simulation only reaches a real-time factor; None: it has caught up."""
        wanted, warning = f'{self._settings.real_time_factor:g}', ''
        if reached is None:
            rospy.loginfo(f'the simulation keeps pace again: real-time factor {wanted}')
        else:
            warning = ('the simulation is too slow: it reaches a real-time factor '
                       f'of {reached:.2g} instead of {wanted}')
            rospy.logwarn(warning)
        self.warn('pace', warning)

    def robots(self):
        """Report what has happened to the robots since the last call."""
        for robot in self._robots:
            if robot.timed_out:  # a Kobuki's driver logs that, too
                robot.timed_out = False
                self._report_timeout(robot)
            lies = not is_upright(robot.ground_truth.orientation)
            if lies == (robot in self._fallen):
                continue
            if lies:
                self._fallen.add(robot)
            else:
                self._fallen.remove(robot)
            self._report_fall(robot)

    def _report_timeout(self, robot):
        """Warn that the watchdog has stopped a robot, but not each time."""
        now = time.monotonic()
        if now > self._timeout_lines.get(robot, -math.inf) + TIMEOUT_LINE_PERIOD:
            self._timeout_lines[robot] = now
            topic = rospy.resolve_name(robot.namespace + 'cmd_vel')
            rospy.logwarn(f'the base stops: no command on {topic} for '
                          f'{self._settings.cmd_vel_timeout:g} s (~cmd_vel_timeout)')

    def _report_fall(self, robot):
        """Warn of a robot that has tipped over, or withdraw that."""
        name, warning = robot.namespace.strip('/') or 'the robot', ''
        if robot in self._fallen:
            # Adding zero turns -0.0 into 0.0.
            x, y = (round(metres, 2) + 0.0 for metres in robot.ground_truth.position[:2])
            warning = (f'{name} lies on its side at x {x:g}, y {y:g}; '
                       '~reset_simulation brings it back')
            rospy.logwarn(warning)
        else:
            rospy.loginfo(f'{name} stands upright again')
        self.warn(name, warning)
