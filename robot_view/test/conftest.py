"""A viewer, a robot, a browser with the page."""

import contextlib

import pytest
import rospy
from odometry_tests.tutorial import detector, simulator
from viewer import Motion, viewing

# What draws without a graphics card leaves little for the robot.
SCALE = 0.5
FRAME_RATE = 2.0  # Hz


@pytest.fixture(scope='module')
def open_page():
    browser = pytest.importorskip('browser', reason='selenium is not installed')
    if not (browser.CHROMIUM and browser.DRIVER):
        pytest.skip('chromium and chromedriver are not installed')
    with contextlib.ExitStack() as stack:
        yield lambda url: stack.enter_context(browser.Page(url, scale=SCALE, frame_rate=FRAME_RATE))


@pytest.fixture(scope='module')
def view(master):
    """Start a viewer in which only what the test does stops the robot."""
    with viewing(patient=True) as running:
        yield running


@pytest.fixture(scope='module')
def robot(master):
    """Start a robot that nothing but a command stops, with a detector."""
    rospy.set_param('/use_sim_time', True)
    with simulator('_cmd_vel_timeout:=0'), detector():
        yield Motion()


@pytest.fixture(scope='module')
def pages():
    return []


@pytest.fixture
def page(open_page, view, pages):
    """Return the viewer's page, which stays open for the next test."""
    if not pages or not pages[-1].is_open:
        pages.append(open_page(view.url))
    yield pages[-1]
    if pages[-1].is_open:
        pages[-1].let_go()
