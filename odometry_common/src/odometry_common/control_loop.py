"""When a controller acts: as its input arrives, and at its own period where that is slow."""

import contextlib
import threading

import rospy

from odometry_common.subscribing import one_at_a_time
from odometry_common.timing import Metronome, Watchdog

PERIODS_UNTIL_SLOW = 2.5  # without input; the clock may be heard a period after it
LOOK_PERIOD = 0.1  # s of real time between two looks after a controller without a period
REAL_SILENCE = 0.2  # s; at up to five times real time the usual timeout is longer
CLOCK_LAG = 60.0  # s of simulated time, by which a busy machine may hear the clock late


class ControlLoop:
    """Has a controller act on the latest input, and stop when no input comes any more."""

    def __init__(self, control, stop, timeout, period=0.0):
        """Begin to wait for input.

        :param control: is called with the latest input and the time (s)
        :param stop: is called again and again while no input has come for `timeout` (s of ROS
            time; 0: for ever)
        :param period: s between two controls; 0: one for each input
        """
        self._control, self._stop = control, stop
        self._metronome = Metronome(period)
        self._slow = Watchdog(PERIODS_UNTIL_SLOW * period)
        self._silent = Watchdog(timeout, min(timeout, REAL_SILENCE))
        self._input, self._stamp = None, 0.0
        if period:
            rospy.Timer(rospy.Duration(period), self._look, reset=True)
        else:
            # A timer of rospy would wake with each tick of the clock, which slows lockstep down.
            threading.Thread(target=self._look_again_and_again, daemon=True).start()

    def hear(self, value, stamp=0.0):
        """Take an input, measured at `stamp` (s; 0: unknown), and control at once if it is time.

        No command then rests on older input, and a simulator in lockstep gets its answer.
        """
        self._input, self._stamp = value, stamp
        now = self._now()
        self._slow.feed(now)
        self._silent.feed(now)
        if self._metronome.is_due(stamp or now):
            self._control(value, now)

    def _look_again_and_again(self):
        ended = threading.Event()
        rospy.on_shutdown(ended.set)
        while not ended.wait(LOOK_PERIOD):
            self._look()

    def _look(self, _event=None):
        with one_at_a_time, contextlib.ExitStack() as failure:
            # An error ends these looks, and nobody would notice silence any more.
            failure.callback(rospy.signal_shutdown, 'the controller has failed')
            now = self._now()
            if self._silent.expired(now):
                self._stop()
            elif self._slow.expired(now):
                self._control(self._input, now)
            failure.pop_all()

    def _now(self):
        """Return ROS time (s).

        Simulated time comes on a connection of its own, and may come after input that is newer.
        Taken for the present, it would make a silence of the time that it is behind.
        """
        now = rospy.get_time()
        behind = not rospy.rostime.is_wallclock() and now < self._stamp < now + CLOCK_LAG
        return self._stamp if behind else now
