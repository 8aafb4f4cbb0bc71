"""A rate for clients of a robot that waits for their commands."""

import rospy

from odometry_tests.waiting import PATIENCE, TIMEOUT


class PunctualRate:
    """Sleeps as rospy.Rate does, but never past the time that is due.

    rospy.Rate.sleep() reads the clock twice. A tick that comes in between makes it sleep a tick
    longer: a client at the rate of the lockstep then waits for the robot's time, which waits for
    the client, until the robot's patience ends and time runs on without any command.
    """

    def __init__(self, rate, begin):
        """Sleep at a rate (Hz), counted from `begin` (rospy.Time)."""
        self._period = rospy.Duration(0, round(1e9 / rate))
        self.due = begin

    def sleep(self):
        """Return once another period has passed on the clock, at once if it has already.

        :raises AssertionError: if it does not pass in time
        """
        self.due += self._period
        ticked = rospy.rostime.get_rostime_cond()
        with ticked:
            passed = ticked.wait_for(lambda: rospy.get_rostime() >= self.due, TIMEOUT * PATIENCE)
        assert passed, f'the clock stands at {rospy.get_time():g} s, before {self.due.to_sec():g} s'
