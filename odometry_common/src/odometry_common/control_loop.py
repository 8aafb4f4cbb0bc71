"""When a controller acts: as input arrives, and at its own period where input is slow."""

import contextlib
import threading

import rospy

from odometry_common.subscribing import one_at_a_time
from odometry_common.timing import Metronome, Watchdog

PERIODS_UNTIL_SLOW = 2.5  # without input; the clock may arrive a period after it
LOOK_PERIOD = 0.1  # s of wall time, for a controller without a period
WALL_SILENCE = 0.2  # s; at up to five times real time the usual timeout is longer
CLOCK_LAG = 60.0  # s of simulated time that the clock may arrive late on a busy machine


class ControlLoop:
    """Calls a controller with the latest input, and stops it when no input arrives any more."""

    def __init__(self, control, stop, timeout, period=0.0):
        """Wait for input.

        :param control: is called with the latest input and the time (s)
        :param stop: is called repeatedly once no input has arrived for `timeout` (s of ROS
            time; 0: never)
        :param period: s between two controls; 0: one for each input
        """
        self._control, self._stop = control, stop
        self._metronome = Metronome(period)
        self._slow = Watchdog(PERIODS_UNTIL_SLOW * period)
        self._silent = Watchdog(timeout, min(timeout, WALL_SILENCE))
        self._input, self._stamp = None, 0.0
        if period:
            rospy.Timer(rospy.Duration(period), self._look, reset=True)
        else:
            # rospy.Timer would wake with each tick of the clock, which slows lockstep down.
            threading.Thread(target=self._look_repeatedly, daemon=True).start()

    def receive(self, value, stamp=0.0):
        """Take an input, measured at `stamp` (s; 0: unknown), and control at once if it is time.

        So each command uses the newest input, and a simulator in lockstep gets its answer.
        """
        self._input, self._stamp = value, stamp
        now = self._now()
        self._slow.feed(now)
        self._silent.feed(now)
        if self._metronome.is_due(stamp or now):
            self._control(value, now)

    def _look_repeatedly(self):
        ended = threading.Event()
        rospy.on_shutdown(ended.set)
        while not ended.wait(LOOK_PERIOD):
            self._look()

    def _look(self, _event=None):
        with one_at_a_time, contextlib.ExitStack() as failure:
            # An error ends this thread, and nothing would notice silence any more.
            failure.callback(rospy.signal_shutdown, 'the controller has failed')
            now = self._now()
            if self._silent.expired(now):
                self._stop()
            elif self._slow.expired(now):
                self._control(self._input, now)
            failure.pop_all()

    def _now(self):
        """Return ROS time (s).

        /clock has a separate connection, so that input may arrive before the clock's tick of the
        same moment. That lag does not count as silence.
        """
        now = rospy.get_time()
        behind = not rospy.rostime.is_wallclock() and now < self._stamp < now + CLOCK_LAG
        return self._stamp if behind else now
