"""What the page shows and does in a real browser: robots, numbers, plots, the pad."""

import numpy
import pytest
import rospy
from geometry_msgs.msg import Vector3
from odometry_tests.processes import rosrun
from odometry_tests.scripts import ROOT
from odometry_tests.tutorial import Truth, detector, simulator
from odometry_tests.waiting import TIMEOUT, wait_until
from std_msgs.msg import ColorRGBA
from viewer import DARK, browsing, viewing
from visualization_msgs.msg import Marker, MarkerArray

ROBOT_PIXELS = 100  # at least so many are the robot's
PICTURE_PERIOD = 0.2  # s
SCAN_PIXELS = 100
WALL_PIXELS = 500
OFF_CENTRE = 0.1  # share of the picture, by which the robot's middle may be off the picture's
PHONE = {'width': 390, 'height': 844, 'deviceScaleFactor': 0.5, 'mobile': True}
PANEL_BOX = ('const box = document.getElementById("readings").closest("[style*=fixed]").getBoundingClientRect();'
             'return [box.left, box.top, box.width, box.height]')
BUTTONS = 'forward', 'left', 'stop', 'right', 'back'


@pytest.fixture(scope='module')
def open_page():
    with browsing() as opened:
        yield opened


@pytest.fixture(scope='module')
def view(master):
    with viewing('_target:=5', patient=True) as running:
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


def wait_for_robot(page):
    """Return once the page has drawn it, with its dark pixels around the middle of the picture."""
    middle = []  # of the robot, as a share of height and width

    def is_in_the_middle():
        scene = page.scene()
        dark = numpy.argwhere(scene.max(axis=2) < DARK)
        middle[:] = dark.mean(axis=0) / scene.shape[:2] if len(dark) > ROBOT_PIXELS else []
        return middle and all(abs(share - 0.5) < OFF_CENTRE for share in middle)

    wait_until(is_in_the_middle, TIMEOUT, lambda: f'the robot in the middle of the picture; it is at {middle}',
               PICTURE_PERIOD)


def test_a_page_without_a_robot_says_what_it_waits_for(page):
    page.wait_for_text('waiting for odometry on /odom')
    page.dismiss_notices()
    wait_until(lambda: page.scene().std() > 1, TIMEOUT, 'a picture that is not blank')
    assert 'distance' not in page.text and 'time' not in page.text.split('plots')[0], 'a row without a value'


def test_the_robot_is_in_the_picture_after_five_metres(robot, page):
    page.wait_for_reading('moved_distance', lambda metres: metres == 0)
    wait_for_robot(page)
    with rosrun('test_movement', 'test_movement.py', '_distance:=5', '_speed:=0.7',
                '_exit_when_done:=true') as mover:
        page.wait_for_text('target')
        assert mover.wait() == 0, mover.output
    robot.wait_until_resting()
    went = pytest.approx(robot.last.pose.pose.position.x, abs=0.002)
    assert went.expected >= 5.0
    for name in 'moved_distance', 'true_distance':
        page.wait_for_reading(name, lambda metres: metres == went)
    page.wait_for_reading('real_time_factor', lambda rate: rate > 0)
    wait_for_robot(page)


def test_a_wall_is_drawn_as_long_as_the_world_has_it(robot, page):
    markers = rospy.Publisher('/sim_turtlebot/world_markers', MarkerArray, queue_size=1, latch=True)
    wall = Marker(type=Marker.CUBE, scale=Vector3(0.1, 2.0, 0.5), color=ColorRGBA(1.0, 0.0, 0.0, 1.0))
    wall.pose.position.x = robot.wait_until_resting().pose.pose.position.x + 1.0
    wall.pose.orientation.w = 1.0
    markers.publish([wall])
    wait_until(lambda: page.count_pixels(0, 1) > WALL_PIXELS, TIMEOUT, 'a red wall in the picture')
    markers.publish([])
    wait_until(lambda: page.count_pixels(0, 1) < WALL_PIXELS / 2, TIMEOUT, 'a picture without it')


def test_the_pad_drives_while_a_button_or_an_arrow_key_is_held(robot, page):
    """Nothing but a command stops this robot; test_page_clients closes a page and the viewer in mid-drive."""
    for sign, press, key in (1, page.hold, 'forward'), (-1, page.press_key, 'ARROW_DOWN'):
        page.wait_for_reading('speed', lambda speed: speed == 0)
        press(key)
        assert sign * robot.wait_until_moving().twist.twist.linear.x > 0
        page.let_go()
        robot.wait_until_resting()


def test_on_a_phone_a_finger_finds_each_button_and_the_robot_is_above_them(robot, page):
    with page.resized(PHONE):
        page.wait_for_text('forward')
        boxes = {}

        def in_panel():
            left, top, width, height = page.run(PANEL_BOX)
            boxes.update({label: page.box(label) for label in BUTTONS})
            return (left, width) == (0, PHONE['width']) and height <= 0.45 * PHONE['height'] and all(
                top < y and y + high <= top + height for _, y, _, high in boxes.values())

        wait_until(in_panel, TIMEOUT, lambda: f'all buttons in a panel as wide as the phone: {boxes}')
        assert all(min(width, height) >= 44 for _, _, width, height in boxes.values()), boxes
        _, top, *_ = page.run(PANEL_BOX)
        wait_until(lambda: len(page.scene()) <= top, TIMEOUT, 'a scene above the panel')
        page.follow()
        wait_for_robot(page)


@pytest.mark.nightly
def test_a_scan_and_odometry_that_is_off_are_drawn(master, open_page):
    """Dots on the walls of the room; a blue ghost where slipping wheels believe the robot to be."""
    with rosrun('sim_turtlebot', 'sim_turtlebot_node.py', '__ns:=slippery', '_scan:=true',
                '_odometry_source:=encoder', '_wheel_slip:=0.4', '_cmd_vel_timeout:=0',
                f'_world:={ROOT}/sim_turtlebot/worlds/room.urdf'), \
            viewing('__ns:=slippery') as view, open_page(view.url) as page:
        truth = Truth('/slippery/')
        page.dismiss_notices()
        wait_until(lambda: page.count_pixels(0, 1) > SCAN_PIXELS, TIMEOUT, 'a scan in the picture')
        assert page.count_pixels(2, 0) < ROBOT_PIXELS / 10
        page.hold('forward')
        page.wait_for_reading('true_distance', lambda metres: metres > 0.5)
        page.let_go()
        truth.wait_until_resting()
        wait_until(lambda: page.count_pixels(2, 0) > ROBOT_PIXELS, TIMEOUT,
                   'a blue robot beside the dark one')


def test_a_lost_connection_is_said_in_words(page, view):
    """The last test of this page."""
    notice = 'return getComputedStyle(document.body, "::after").content'
    assert page.run(notice) == 'none'
    view.end()
    wait_until(lambda: 'Connection lost' in page.run(notice), TIMEOUT, lambda: page.run(notice))
