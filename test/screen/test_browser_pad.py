"""The pad of the browser window, in a real browser: it drives, and nobody can lose the robot."""

import signal

import pytest
import rospy
from geometry_msgs.msg import Twist
from odometry_tests.viewing import MOVING, REACTION_TIME, View

HOLD_TIMEOUT = 0.5  # s, after which a page that says no more holds nothing


def test_the_pad_drives_while_it_is_held(robot, page):
    """Pressed, it drives; released, the last command is zero and no other follows."""
    page.wait_for_reading('speed', lambda speed: speed == 0)
    robot.commands.clear()
    page.hold('forward')
    robot.wait_until_moving()
    page.wait_for_reading('speed', lambda speed: speed == pytest.approx(0.2, abs=0.02))
    page.release()
    robot.assert_it_stops(within=REACTION_TIME)


def test_an_arrow_key_drives_while_it_is_held(robot, page):
    """As the pad does."""
    page.wait_for_reading('speed', lambda speed: speed == 0)
    robot.commands.clear()
    robot.clear()
    page.press_key('ARROW_DOWN')
    robot.wait_for(lambda m: m.twist.twist.linear.x < -MOVING, what='a robot that moves backwards')
    page.release_key('ARROW_DOWN')
    robot.assert_it_stops(within=REACTION_TIME)


def test_stop_commands_zero(robot, page):
    """Also if it was not the pad that drove."""
    page.wait_for_reading('speed', lambda speed: speed == 0)
    publisher = rospy.Publisher('cmd_vel', Twist, queue_size=1, latch=True)
    command = Twist()
    command.linear.x = 0.2
    publisher.publish(command)
    robot.wait_until_moving()
    page.click('stop')
    robot.wait_until_resting()
    publisher.unregister()


def close(page):
    """Close the page."""
    page.close()


def hang(page):
    """Let the page be busy in a moment, for so long that it can say nothing to the viewer."""
    page.run('setTimeout(() => {const end = Date.now() + 5000; while (Date.now() < end);}, 300)')


@pytest.mark.parametrize('ending, time_limit', [(hang, 0.3 + HOLD_TIMEOUT + REACTION_TIME),
                                                (close, REACTION_TIME)])
def test_a_page_that_goes_away_in_mid_drive_stops_the_robot(robot, page, ending, time_limit):
    """Nobody is left to release the button."""
    page.wait_for_reading('speed', lambda speed: speed == 0)
    robot.commands.clear()
    page.hold('forward')
    robot.wait_until_moving()
    ending(page)
    robot.assert_it_stops(within=time_limit)


def test_the_robot_stops_when_the_viewer_ends(robot, browser):
    """Its last word is zero, also with somebody's finger on the button; it ends at once."""
    with View() as short_lived, browser.open(short_lived.url) as page:
        page.wait_for_reading('speed', lambda speed: speed == 0)
        page.hold('forward')
        robot.wait_until_moving()
        assert short_lived.process.end(signal.SIGTERM, timeout=3.0) == 0
        robot.assert_it_stops(within=REACTION_TIME)
    assert 'Traceback' not in short_lived.process.output
