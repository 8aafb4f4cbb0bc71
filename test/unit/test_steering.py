"""Who holds the pad's buttons, and what the robot is told."""

import pytest
from robot_view.steering import (
    BACK,
    COMMAND_PERIOD,
    FORWARD,
    HOLD_RATE,
    HOLD_TIMEOUT,
    LEFT,
    STANDSTILL,
    STOP,
    HeldButtons,
    Steering,
)


def test_a_hold_lasts_until_it_is_released_or_no_more_is_heard():
    """A page that has gone cannot say so."""
    buttons = HeldButtons()
    buttons.hold('page', FORWARD, 0.0)
    assert buttons.command(HOLD_TIMEOUT - 0.01) == (1, 0)
    assert buttons.command(HOLD_TIMEOUT + 0.01) is None
    buttons.hold('page', FORWARD, 1.0)
    buttons.release('page', FORWARD)
    assert buttons.command(1.0) is None


def test_what_is_held_adds_up():
    """Forward and left is a curve, forward and back is a standstill."""
    buttons = HeldButtons()
    buttons.hold('page', FORWARD, 0.0)
    buttons.hold('page', LEFT, 0.0)
    assert buttons.command(0.1) == (1, 1)
    buttons.release('page', LEFT)
    buttons.hold('page', BACK, 0.0)
    assert buttons.command(0.1) == (0, 0)


def test_pages_hold_by_themselves():
    """Two that hold the same do not double it; one that goes leaves the other's."""
    buttons = HeldButtons()
    buttons.hold('one', FORWARD, 0.0)
    buttons.hold('other', FORWARD, 0.0)
    assert buttons.command(0.1) == (1, 0)
    buttons.release('one')
    assert buttons.command(0.1) == (1, 0)
    buttons.clear()
    assert buttons.command(0.1) is None


def test_stop_overrules_whatever_is_held():
    """On whichever page."""
    buttons = HeldButtons()
    buttons.hold('one', FORWARD, 0.0)
    buttons.hold('other', STOP, 0.0)
    assert buttons.command(0.1) == (0, 0)


def test_a_page_that_hangs_drives_no_longer_than_a_hold_lasts():
    """The last word is one zero; until then the robot is told all the time."""
    steering = Steering()
    steering.choose('')
    steps_between_holds = round(1 / HOLD_RATE / COMMAND_PERIOD)
    hangs_after = 20
    heard = []
    for step in range(hangs_after + 100):
        now = COMMAND_PERIOD * step
        if step <= hangs_after and step % steps_between_holds == 0:
            steering.hold('page', FORWARD, now)
        heard.append(steering.commands(now))
    last = heard.index([('', STANDSTILL)])
    assert (last - hangs_after) * COMMAND_PERIOD == pytest.approx(HOLD_TIMEOUT, abs=COMMAND_PERIOD)
    assert heard[:last] == [[('', (1, 0))]] * last
    assert not any(heard[last + 1:])


def test_a_release_is_one_zero_at_once():
    """And nothing after it."""
    steering = Steering()
    steering.choose('')
    steering.hold('page', LEFT, 0.0)
    assert steering.commands(0.0) == [('', (0, 1))] and steering.is_driving
    steering.release('page', LEFT)
    assert steering.commands(0.0) == [('', STANDSTILL)] and not steering.is_driving
    assert steering.commands(0.0) == []


def test_another_robot_is_not_driven_before_the_first_one_stands():
    """Who changes the robot lets go of the old one's button."""
    steering = Steering()
    steering.choose('robot_1/')
    steering.hold('page', FORWARD, 0.0)
    steering.commands(0.0)
    steering.choose('robot_2/')
    steering.hold('page', FORWARD, 0.1)
    assert steering.commands(0.1) == [('robot_1/', STANDSTILL), ('robot_2/', (1, 0))]


def test_without_a_robot_nothing_is_commanded():
    """A page may be there first."""
    steering = Steering()
    steering.hold('page', FORWARD, 0.0)
    assert steering.commands(0.0) == [] and not steering.is_driving
