"""The pad in a real browser: it drives while it is held.

How long a page that falls silent goes on driving is tested with a stepped clock, in
test_steering.py.
"""

import signal

import pytest
from viewer import MOVING

PATIENT = True  # then only what the test does stops the robot


@pytest.fixture
def driven(robot, page):
    """Hold the forward button until the robot moves."""
    page.wait_for_reading('speed', lambda speed: speed == 0)
    robot.commands.clear()
    page.hold('forward')
    robot.wait_until_moving()
    robot.commands.wait_for_publisher()
    return robot


def test_the_pad_drives_while_it_is_held(driven, page):
    page.wait_for_reading('speed', lambda speed: speed == pytest.approx(0.2, abs=0.02))
    page.release()
    driven.wait_until_stopped()


def test_an_arrow_key_drives_while_it_is_held(robot, page):
    page.wait_for_reading('speed', lambda speed: speed == 0)
    robot.commands.clear()
    robot.clear()
    page.press_key('ARROW_DOWN')
    robot.wait_for(lambda m: m.twist.twist.linear.x < -MOVING, what='a robot that moves backwards')
    robot.commands.wait_for_publisher()
    page.release_key('ARROW_DOWN')
    robot.wait_until_stopped()


def test_a_page_that_is_closed_in_mid_drive_stops_the_robot(driven, page):
    """Nobody is left to release the button."""
    page.close()
    driven.wait_until_stopped()


def test_the_robot_stops_when_the_viewer_exits(driven, view, page):
    assert view.end(signal.SIGTERM) == 0, view.output
    driven.wait_until_stopped()
    page.close()
