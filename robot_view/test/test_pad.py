"""What the held buttons of the pad command."""

import math

import pytest
import rosgraph
from geometry_msgs.msg import Twist
from odometry_tests.waiting import TIMEOUT, Recorder, wait_until
from robot_view.steering import (
    BACK,
    COMMAND_PERIOD,
    FORWARD,
    HOLD_RATE,
    HOLD_TIMEOUT,
    LEFT,
    RIGHT,
    STANDSTILL,
    STOP,
    Steering,
)

from robot_view import pad


@pytest.mark.parametrize('held, shares', [
    ([('page', FORWARD)], (1, 0)), ([('page', FORWARD), ('page', LEFT)], (1, 1)),
    ([('page', FORWARD), ('page', BACK)], (0, 0)), ([('page', FORWARD), ('other', FORWARD)], (1, 0)),
    ([('page', FORWARD), ('other', STOP)], (0, 0))])
def test_held_buttons_add_up_and_stop_overrules_them(held, shares):
    """Two pages that hold the same button do not double it."""
    steering = Steering()
    for client, button in held:
        steering.hold(client, button, '', 0.0)
    assert steering.commands(0.0) == {'': shares}


def test_a_page_that_hangs_drives_until_its_hold_expires():
    """A command in each period until then, one zero, and nothing after it."""
    steering = Steering()
    steps_between_holds = round(1 / HOLD_RATE / COMMAND_PERIOD)
    hangs_after = 20
    sent = []
    for step in range(hangs_after + 100):
        now = COMMAND_PERIOD * step
        if step <= hangs_after and step % steps_between_holds == 0:
            steering.hold('page', FORWARD, '', now)
        sent.append(steering.commands(now))
    last = sent.index({'': STANDSTILL})
    assert (last - hangs_after) * COMMAND_PERIOD == pytest.approx(HOLD_TIMEOUT, abs=COMMAND_PERIOD)
    assert sent[:last] == [{'': (1, 0)}] * last
    assert not any(sent[last + 1:]) and not steering.is_driving


def test_a_release_is_one_zero_at_once():
    """A page that closes releases all its buttons, and none of another page."""
    steering = Steering()
    steering.hold('page', LEFT, '', 0.0)
    steering.hold('other', FORWARD, '', 0.0)
    assert steering.commands(0.0) == {'': (1, 1)} and steering.is_driving
    steering.release('page')
    assert steering.commands(0.0) == {'': (1, 0)}
    steering.release('other', BACK)
    assert steering.commands(0.0) == {'': (1, 0)}
    steering.release('other', FORWARD)
    assert steering.commands(0.0) == {'': STANDSTILL} and not steering.is_driving
    assert steering.commands(0.0) == {}


def test_the_first_robot_stops_before_another_one_starts():
    """A page chooses another robot while it holds a button."""
    steering = Steering()
    steering.hold('page', FORWARD, 'robot_1/', 0.0)
    steering.commands(0.0)
    steering.hold('page', FORWARD, 'robot_2/', 0.1)
    assert list(steering.commands(0.1).items()) == [('robot_1/', STANDSTILL), ('robot_2/', (1, 0))]


def test_a_stop_lasts_until_the_buttons_are_pressed_anew():
    """By everybody who held one, also by a page that was silent just then; others may drive."""
    steering = Steering()
    steering.hold('silent', LEFT, '', -1.0)
    steering.hold('page', FORWARD, '', 0.0)
    assert steering.commands(0.0) == {'': (1, 0)}
    steering.hold('other', STOP, '', 0.1)
    for now in (0.1 * step for step in range(1, 30)):
        steering.hold('page', FORWARD, '', now)
        steering.hold('silent', LEFT, '', now)
        assert steering.commands(now).get('', STANDSTILL) == STANDSTILL
    steering.hold('other', RIGHT, '', 3.0)
    assert steering.commands(3.0) == {'': (0, -1)}
    steering.release('page', FORWARD)
    steering.hold('page', FORWARD, '', 3.1)
    assert steering.commands(3.1) == {'': (1, -1)}


def test_a_robot_that_does_not_listen_keeps_no_other_one_driving(master, monkeypatch):
    """The last command of that one would stand."""
    monkeypatch.setattr(pad, 'CONNECTING_TIMEOUT', math.inf)
    received = Recorder('/heard/cmd_vel', Twist)
    chosen = ['/heard/']
    driver = pad.Pad(lambda: chosen[0], lambda: (0.2, 1.0))
    wait_until(lambda: driver.hold('page', FORWARD) or received.messages, TIMEOUT, 'a command')
    chosen[0] = '/unheard/'
    driver.hold('other', LEFT)
    received.wait_for(lambda m: m == Twist(), what='zero')


@pytest.mark.parametrize('button', [STOP, FORWARD])
def test_a_button_released_before_the_robot_subscribes_stops_it(master, monkeypatch, button):
    """To connect takes a moment, on a busy machine longer than a click."""
    monkeypatch.setattr(pad, 'CONNECTING_TIMEOUT', math.inf)
    namespace = f'/late_for_{button}/'
    driver = pad.Pad(lambda: namespace, lambda: (0.2, 1.0))

    def is_advertised():
        driver.hold('page', button)
        return f'{namespace}cmd_vel' in dict(rosgraph.Master('/test').getSystemState()[0])

    wait_until(is_advertised, TIMEOUT, 'a publisher of cmd_vel')
    driver.release('page')
    received = Recorder(f'{namespace}cmd_vel', Twist)
    assert received.wait_for() == Twist()
