"""A viewer, a robot, a browser with the page."""

import pytest
import rospy
from odometry_tests.tutorial import detector, simulator
from viewer import Motion, View

# What draws without a graphics card leaves little for the robot.
SCALE = 0.5
FRAME_RATE = 2.0  # Hz


@pytest.fixture(scope='module')
def browser():
    """Start a browser."""
    chromium = pytest.importorskip('odometry_tests.browser', reason='selenium is not installed')
    if not (chromium.CHROMIUM and chromium.DRIVER):
        pytest.skip('chromium and chromedriver are not installed')
    with chromium.Browser(scale=SCALE, frame_rate=FRAME_RATE) as running:
        yield running


@pytest.fixture(scope='module')
def view(master, request):
    """Start a viewer, patient if the module says so."""
    with View(patient=getattr(request.module, 'PATIENT', False)) as running:
        yield running


@pytest.fixture(scope='module')
def robot(master):
    """Start a robot that nothing but a command stops, with a detector."""
    rospy.set_param('/use_sim_time', True)
    with simulator('_cmd_vel_timeout:=0'), detector():
        yield Motion()


@pytest.fixture
def page(browser, view):
    """Return the viewer's page, which stays open for the next test."""
    found = browser.find(view.url) or browser.open(view.url)
    yield found
    if found.is_open:
        found.let_go()
