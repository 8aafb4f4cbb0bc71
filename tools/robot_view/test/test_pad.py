"""What the held buttons of the pad command."""

import math
import time

import pytest
import rosgraph
from geometry_msgs.msg import Twist
from odometry_tests.waiting import TIMEOUT, Recorder, wait_until
from robot_view import pad
from robot_view.steering import (
    COMMAND_PERIOD,
    FORWARD,
    HOLD_TIMEOUT,
    LEFT,
    RIGHT,
    STANDSTILL,
    STOP,
    Steering,
)


def send(steering, now):
    """Return the commands; each zero arrives."""
    commands = steering.commands(now)
    for robot, shares in commands.items():
        if shares == STANDSTILL:
            steering.confirm_stop(robot)
    return commands


def test_held_buttons_add_up_until_they_are_released():
    """A + holds a button, a - releases it, or all of a page; a robot gets one zero.

    Two pages that hold the same button do not double it; one that closes releases none of the other's.
    """
    steering = Steering()
    for event, expected in (
            ('+page forward', (1, 0)), ('+page back', (0, 0)), ('-page back', (1, 0)), ('+other forward', (1, 0)),
            ('+page left', (1, 1)), ('-page', (1, 0)), ('-other forward', (0, 0)), ('-page', None)):
        client, *button = event[1:].split()
        if event[0] == '-':
            steering.release(client, *button)
        else:
            steering.hold(client, *button, '', 0.0)
        assert send(steering, 0.0).get('') == expected, event


def test_a_button_drives_the_robot_for_which_it_was_pressed_and_another_one_only_after_its_zero():
    """Another browser may choose another robot meanwhile."""
    steering = Steering()
    for robot in 'robot_1/', 'robot_2/':
        steering.hold('page', FORWARD, robot, 0.0)
        assert send(steering, 0.0) == {'robot_1/': (1, 0)}
    steering.release('page')
    steering.hold('page', FORWARD, 'robot_2/', 0.0)
    assert list(send(steering, 0.0).items()) == [('robot_1/', (0, 0)), ('robot_2/', (1, 0))]


def test_a_page_that_hangs_drives_until_its_hold_expires():
    """A command in each period until then, one zero, and nothing after it."""
    steering = Steering()
    for step in range(2):  # the page repeats its hold once
        steering.hold('page', FORWARD, '', COMMAND_PERIOD * step)
        assert send(steering, COMMAND_PERIOD * step) == {'': (1, 0)}
    sent = [send(steering, COMMAND_PERIOD * step) for step in range(2, 100)]
    last = round(HOLD_TIMEOUT / COMMAND_PERIOD) - 1
    assert sent[:last] == [{'': (1, 0)}] * last
    assert sent[last] == {'': STANDSTILL}
    assert not any(sent[last + 1:]) and not steering.is_driving


def test_a_stop_lasts_until_the_buttons_are_pressed_anew():
    """By everybody who held one, also by a page that was silent just then; others may drive."""
    steering = Steering()
    steering.hold('silent', LEFT, '', -1.0)
    steering.hold('page', FORWARD, '', 0.0)
    steering.hold('other', STOP, '', 0.1)
    for now in 0.1, 0.2, 2.0:
        steering.hold('page', FORWARD, '', now)
        steering.hold('silent', LEFT, '', now)
        assert steering.commands(now).get('', STANDSTILL) == STANDSTILL
    steering.hold('other', RIGHT, '', 3.0)
    assert steering.commands(3.0) == {'': (0, -1)}
    steering.release('page', FORWARD)
    steering.hold('page', FORWARD, '', 3.1)
    assert steering.commands(3.1) == {'': (1, -1)}


def test_a_robot_gets_no_more_commands_than_it_can_take_and_zero_also_if_the_next_one_does_not_listen(
        master, monkeypatch):
    """However many holds the pages send; its last command would stand."""
    monkeypatch.setattr('robot_view.steering.STOP_TIMEOUT', math.inf)
    received = Recorder('/heard/cmd_vel', Twist)
    chosen = ['/heard/']
    driver = pad.Pad(lambda: chosen[0], lambda: (0.2, 1.0))
    wait_until(lambda: driver.hold('page', FORWARD) or received.messages, TIMEOUT, 'a command')
    end, before = time.monotonic() + 0.5, len(received.messages)
    while time.monotonic() < end:
        driver.hold('page', FORWARD)
    assert len(received.messages) - before <= 0.5 / pad.MIN_PERIOD + 2, 'two may be on their way'
    chosen[0] = '/unheard/'
    driver.hold('other', LEFT)
    received.wait_for(lambda m: m == Twist(), what='zero')


@pytest.mark.parametrize('button', [STOP, FORWARD])
def test_a_button_released_before_the_robot_subscribes_stops_it(master, monkeypatch, button):
    """To connect takes a moment, on a busy machine longer than a click."""
    monkeypatch.setattr('robot_view.steering.STOP_TIMEOUT', math.inf)
    namespace = f'/late_for_{button}/'
    driver = pad.Pad(lambda: namespace, lambda: (0.2, 1.0))

    def is_advertised():
        driver.hold('page', button)
        return f'{namespace}cmd_vel' in dict(rosgraph.Master('/test').getSystemState()[0])

    wait_until(is_advertised, TIMEOUT, 'a publisher of cmd_vel')
    driver.release('page')
    received = Recorder(f'{namespace}cmd_vel', Twist)
    assert received.wait_for() == Twist()
