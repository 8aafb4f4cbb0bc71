"""What the page shows and does in a real browser: robots, numbers, plots, the pad."""

import contextlib

import numpy
import pytest
import rospy
from odometry_tests.processes import rosrun
from odometry_tests.scripts import ROOT
from odometry_tests.tutorial import Truth, detector, simulator
from odometry_tests.waiting import TIMEOUT, wait_until
from viewer import ROBOT_PIXELS, viewing, wait_for_robot

SCAN_PIXELS = 100
SCENE_WIDTH = 276  # pixels, between the panels


@pytest.fixture(scope='module')
def open_page():
    browser = pytest.importorskip('browser', reason='selenium is not installed')
    if not (browser.CHROMIUM and browser.DRIVER):
        pytest.skip('chromium and chromedriver are not installed')
    with contextlib.ExitStack() as stack:
        yield lambda url: stack.enter_context(browser.Page(url))


@pytest.fixture(scope='module')
def view(master):
    with viewing(patient=True) as running:
        yield running


@pytest.fixture(scope='module')
def robot(master):
    """Start a robot that nothing but a command stops, with a detector."""
    rospy.set_param('/use_sim_time', True)
    with simulator('_cmd_vel_timeout:=0'), detector():
        yield Truth()


@pytest.fixture(scope='module')
def open_view(open_page, view):
    return open_page(view.url)


@pytest.fixture
def page(open_view):
    yield open_view
    open_view.let_go()


def count_pixels(page, more, less):
    """Return how many pixels have clearly more of one colour (0 to 2) than of another."""
    colours = numpy.moveaxis(page.scene(), 2, 0)
    return (colours[more] - colours[less] > 50).sum()


def test_a_page_without_a_robot_says_what_it_waits_for(page):
    page.wait_for_text('waiting for odometry on /odom')
    page.dismiss_notices()
    assert page.scene().std() > 1, 'the picture is blank'
    assert page.reading('moved_distance') is None


def test_the_page_shows_the_robot_drive_two_metres(robot, page):
    page.wait_for_reading('moved_distance', lambda metres: metres == 0)
    # Until the page is complete, other parts may be as dark.
    rows, columns = wait_for_robot(page, lambda _, columns: columns.max() < SCENE_WIDTH / 2)
    with rosrun('test_movement', 'test_movement.py', '_speed:=0.5',
                '_exit_when_done:=true') as mover:
        assert mover.wait() == 0, mover.output
    robot.wait_until_resting()
    went = pytest.approx(robot.last.pose.pose.position.x, abs=0.002)
    assert went.expected >= 2.0
    for name in 'moved_distance', 'true_distance':
        page.wait_for_reading(name, lambda metres: metres == went)
    page.wait_for_reading('real_time_factor', lambda rate: rate > 0)
    # Two metres are about half the width of what the camera sees.
    wait_for_robot(page, lambda end_rows, end_columns: end_columns.mean() - columns.mean() > 75
                   and abs(end_rows.mean() - rows.mean()) < 15)


def test_the_page_shows_a_heading_and_its_target(robot, page):
    """The target of rotate.py is drawn beside the heading."""
    with rosrun('rotate_robot', 'rotate.py', '_target:=30', '_kp:=1') as rotator:
        page.wait_for_text('target')
        page.wait_for_reading('heading', lambda degrees: degrees == pytest.approx(30, abs=2))
        assert rotator.end() == 0, rotator.output


@pytest.mark.nightly
def test_the_buttons_pause_resume_and_reset_the_simulation(robot, page):
    page.wait_for_text('pause')
    page.click('pause')
    page.wait_for_reading('real_time_factor', lambda rate: rate == 0)
    page.wait_for_reading('simulated_time', lambda seconds: seconds == pytest.approx(robot.stamp, abs=0.051))
    page.click('resume')
    page.wait_for_reading('real_time_factor', lambda rate: rate > 0)
    robot.clear()
    page.click('reset')
    start = robot.wait_for(lambda m: m.header.seq == 0, what='a robot at its start')
    assert abs(start.pose.pose.position.x) < 1e-3
    page.wait_for_reading('true_distance', lambda metres: metres == 0)


def test_the_pad_drives_while_a_button_or_an_arrow_key_is_held(robot, page):
    """Nothing but a command stops this robot; test_page_clients closes a page and the viewer in mid-drive."""
    for sign, begin, end in [(1, lambda: page.hold('forward'), page.release),
                             (-1, lambda: page.press_key('ARROW_DOWN'), lambda: page.release_key('ARROW_DOWN'))]:
        page.wait_for_reading('speed', lambda speed: speed == 0)
        begin()
        assert sign * robot.wait_until_moving().twist.twist.linear.x > 0
        end()
        robot.wait_until_resting()


@pytest.mark.nightly
def test_a_scan_and_odometry_that_is_off_are_drawn(master, open_page):
    """Dots on the walls of the room; a blue ghost where slipping wheels believe the robot to be."""
    with rosrun('sim_turtlebot', 'sim_turtlebot_node.py', '__ns:=slippery', '_scan:=true',
                '_odometry_source:=encoder', '_wheel_slip:=0.4', '_cmd_vel_timeout:=0',
                f'_world:={ROOT}/sim_turtlebot/worlds/room.urdf'), \
            viewing('__ns:=slippery') as view, open_page(view.url) as page:
        truth = Truth('/slippery/')
        page.dismiss_notices()
        wait_until(lambda: count_pixels(page, 0, 1) > SCAN_PIXELS, TIMEOUT, 'a scan in the picture')
        assert count_pixels(page, 2, 0) < ROBOT_PIXELS / 10
        page.hold('forward')
        page.wait_for_reading('true_distance', lambda metres: metres > 0.5)
        page.release()
        truth.wait_until_resting()
        wait_until(lambda: count_pixels(page, 2, 0) > ROBOT_PIXELS, TIMEOUT,
                   'a blue robot beside the dark one')
