"""The pad of the browser window, in a real browser: it drives, and nobody can lose the robot.

How long a page that says no more goes on driving is tested with a stepped clock, in
unit/test_viewer.py.
"""

import signal

import pytest
import rospy
from geometry_msgs.msg import Twist
from odometry_tests.viewing import MOVING, View

# So it is not this that stops the robot, but what the test is about.
WITHOUT_WATCHDOG = pytest.mark.parametrize('view', [{'patient': True}], indirect=True)


def drive(robot, page):
    """Hold a button until the robot moves."""
    page.wait_for_reading('speed', lambda speed: speed == 0)
    robot.commands.clear()
    page.hold('forward')
    robot.wait_until_moving()


@WITHOUT_WATCHDOG
def test_the_pad_drives_while_it_is_held(robot, page):
    """Pressed, it drives; released, the last command is zero and no other follows."""
    drive(robot, page)
    page.wait_for_reading('speed', lambda speed: speed == pytest.approx(0.2, abs=0.02))
    page.release()
    robot.wait_until_stopped()


@WITHOUT_WATCHDOG
def test_an_arrow_key_drives_while_it_is_held(robot, page):
    """As the pad does."""
    page.wait_for_reading('speed', lambda speed: speed == 0)
    robot.commands.clear()
    robot.clear()
    page.press_key('ARROW_DOWN')
    robot.wait_for(lambda m: m.twist.twist.linear.x < -MOVING, what='a robot that moves backwards')
    page.release_key('ARROW_DOWN')
    robot.wait_until_stopped()


@WITHOUT_WATCHDOG
def test_a_page_that_is_closed_in_mid_drive_stops_the_robot(robot, page):
    """Nobody is left to release the button."""
    drive(robot, page)
    page.close()
    robot.wait_until_stopped()


def test_a_page_that_hangs_in_mid_drive_stops_the_robot(robot, page):
    """It cannot tell whether the button is still held."""
    drive(robot, page)
    with page.hanging():
        robot.wait_until_stopped()


def test_stop_commands_zero(robot, page):
    """Also if it was not the pad that drove."""
    page.wait_for_reading('speed', lambda speed: speed == 0)
    publisher = rospy.Publisher('cmd_vel', Twist, queue_size=1, latch=True)
    command = Twist()
    command.linear.x = 0.2
    publisher.publish(command)
    robot.wait_until_moving()
    page.click('stop')
    robot.wait_until_stopped()
    publisher.unregister()


def test_the_robot_stops_when_the_viewer_ends(robot, browser):
    """Its last word is zero, also with somebody's finger on the button; it ends at once."""
    with View(patient=True) as short_lived, browser.open(short_lived.url) as page:
        drive(robot, page)
        assert short_lived.process.end(signal.SIGTERM) == 0, short_lived.process.output
        robot.wait_until_stopped()
    assert 'Traceback' not in short_lived.process.output
