"""What the log and ~warning say of the robots, and of the pace."""

import rospy

from sim_turtlebot.falls import FallDetector

TIMEOUT_LINE_PERIOD = 10.0  # s of wall time


class Reports:
    """Reports robots that have fallen or that their watchdogs have stopped, and a simulation that is too slow."""

    def __init__(self, robots, namespaces, settings, warn):
        """Take the robots with their namespaces.

        :param warn: called with a cause and a warning, or '' if that is over
        """
        self._robots = list(zip(robots, namespaces))
        self._settings, self._warn = settings, warn
        self._falls = FallDetector(robots)

    def pace(self, reached):
        """Report that the simulation only reaches a real-time factor; None: it has caught up."""
        wanted, warning = f'{self._settings.real_time_factor:g}', ''
        if reached is None:
            rospy.loginfo(f'the simulation keeps pace again: real-time factor {wanted}')
        else:
            warning = f'the simulation is too slow: it reaches a real-time factor of {reached:.2g} instead of {wanted}'
            rospy.logwarn(warning)
        self._warn('pace', warning)

    def robots(self):
        """Report what has happened to the robots since the last call."""
        self._report_timeouts()
        for name, warning in self._falls.changes():
            log = rospy.logwarn if warning else rospy.loginfo
            log(warning or f'{name} stands upright again')
            self._warn(name, warning)

    def _report_timeouts(self):
        """Log a stop by a watchdog, as a Kobuki's driver does."""
        for robot, namespace in self._robots:
            if robot.timed_out:
                robot.timed_out = False
                rospy.logwarn_throttle(TIMEOUT_LINE_PERIOD, (
                    f'the base stops: no command on {rospy.resolve_name(namespace + "cmd_vel")} for '
                    f'{self._settings.cmd_vel_timeout:g} s (~cmd_vel_timeout)'))
