"""When a controller acts and when it stops, by a clock and messages that the test makes up."""

from types import SimpleNamespace
from unittest.mock import Mock

import pytest
from odometry_common.control_loop import ControlLoop

PERIOD = 0.1  # s
START = 100.0  # s
HOUR = 3600.0  # s


class Controller:
    """A controller whose clock stands still until the test advances it."""

    def __init__(self, monkeypatch, timeout=1.0, period=PERIOD, wallclock=False):
        """Start it, in real time (as `wallclock` says) or in simulated time."""
        self.now, self.real, self.done = START, START, []
        monkeypatch.setattr('odometry_common.control_loop.rospy', SimpleNamespace(
            Timer=Mock(), Duration=Mock(), get_time=lambda: self.now,
            signal_shutdown=self.done.append,
            rostime=SimpleNamespace(is_wallclock=lambda: wallclock)))
        monkeypatch.setattr('odometry_common.control_loop.threading', Mock())
        monkeypatch.setattr(
            'odometry_common.timing.time', SimpleNamespace(monotonic=lambda: self.real))
        self.loop = ControlLoop(
            lambda value, _now: self.done.append(value), lambda: self.done.append('stop'),
            timeout, period)

    def look_on(self, *durations):
        """Let so many seconds pass, simulated and real, each with a look; return what was done."""
        self.done.clear()
        for duration in durations:
            self.now += duration
            self.real += max(duration, 0.0)
            self.loop._look(None)
        return self.done

    def receive(self, value, stamp=0.0):
        """Pass on an input; return what was done."""
        self.done.clear()
        self.loop.receive(value, stamp)
        return self.done


@pytest.fixture
def start(monkeypatch):
    return lambda **options: Controller(monkeypatch, **options)


def test_without_a_period_each_input_is_answered_and_nothing_else_is_done(start):
    """Nothing before the first; several inputs may come at the same time."""
    controller = start(period=0.0)
    assert controller.look_on(*[PERIOD] * 100) == []
    assert [controller.receive(value)[:] for value in 'aab'] == [['a'], ['a'], ['b']]
    assert controller.look_on(*[PERIOD] * 10) == []


def test_input_that_comes_faster_is_answered_once_in_a_period(start):
    controller = start()
    controller.now += 1.0
    answers = [controller.receive(number, START + number * PERIOD / 2)[:] for number in range(6)]
    assert answers == [[0], [], [2], [], [4], []]


def test_slow_input_is_controlled_on_at_the_period(start):
    """With the latest one, once a third look finds nothing newer."""
    controller = start()
    controller.receive('a')
    assert controller.look_on(PERIOD, PERIOD) == []
    assert controller.look_on(*[PERIOD] * 5) == ['a'] * 5
    assert controller.receive('b') == ['b']
    assert controller.look_on(PERIOD, PERIOD) == []


@pytest.mark.parametrize('period', [0.0, PERIOD])
def test_silence_stops_the_controller_until_input_returns(start, period):
    controller = start(period=period)
    controller.receive('a')
    assert 'stop' not in controller.look_on(*[PERIOD] * 9)
    assert controller.look_on(2 * PERIOD, PERIOD) == ['stop', 'stop']
    assert controller.receive('b') == ['b']
    assert 'stop' not in controller.look_on(*[PERIOD] * 9)


def test_silence_lasts_a_while_in_real_time_too(start):
    """A clock that leaps by an hour leaves messages no time to come."""
    controller = start(period=0.0)
    controller.receive('a')
    controller.now += HOUR
    assert controller.look_on(0.0, 0.19) == []
    assert controller.look_on(0.02) == ['stop']


def test_a_clock_that_arrives_late_makes_no_silence(start):
    """It catches up with the input, which is newer, in as many leaps as it likes."""
    controller = start(timeout=0.5)
    controller.receive('a', START + 5.0)
    assert controller.look_on(1.0, 3.0, 1.0, 0.2) == []
    assert controller.look_on(0.1) == ['a']
    assert controller.look_on(0.3) == ['stop']


@pytest.mark.parametrize('wallclock, ahead', [(True, 5.0), (False, HOUR)])
def test_a_stamp_that_cannot_be_right_puts_no_stop_off(start, wallclock, ahead):
    """That of another machine, whose clock is ahead, or one an hour ahead of simulated time."""
    controller = start(wallclock=wallclock)
    controller.receive('a', START + ahead)
    assert controller.look_on(1.01) == ['stop']


def test_time_that_goes_back_starts_a_new_silence(start):
    controller = start(period=0.0)
    controller.receive('a')
    assert controller.look_on(-90.0, 0.9) == []
    assert controller.look_on(0.2) == ['stop']


@pytest.mark.parametrize('action, silence', [('_control', 0.3), ('_stop', 2.0)])
def test_an_error_between_inputs_ends_the_node(start, action, silence):
    """Nothing would notice silence any more; the node sends zero before it exits."""
    controller = start()
    controller.receive('a')
    setattr(controller.loop, action, Mock(side_effect=OSError))
    controller.now, controller.real = START + silence, START + silence
    with pytest.raises(OSError):
        controller.loop._look(None)
    assert controller.done == ['a', 'the controller has failed']
