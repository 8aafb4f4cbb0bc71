"""Other robots in the browser window: a real one, one whose wheels slip, two in a world."""

import math

import numpy
import pytest
import rospy
from nav_msgs.msg import Odometry
from odometry_tests.messages import odometry
from odometry_tests.processes import rosrun
from odometry_tests.robots import place
from odometry_tests.scripts import ROOT
from odometry_tests.viewing import ROBOT_PIXELS, Motion, View, wait_for_robot
from odometry_tests.waiting import TIMEOUT, wait_until

SCAN_PIXELS = 100


def test_a_real_robot_is_shown_by_its_odometry_alone(master, browser):
    """Without truth, detector and simulator the page says what it lacks and shows the rest."""
    with View('__ns:=real') as view:
        publisher = rospy.Publisher('/real/odom', Odometry, queue_size=1, latch=True)
        publisher.publish(odometry(x=1.0, y=0.5, yaw=math.radians(30), stamp=5.0))
        with browser.open(view.url) as page:
            page.wait_for_reading('heading', lambda degrees: degrees == pytest.approx(30))
            page.wait_for_text('no simulator here')
            assert page.reading('true_distance') is None
            assert page.reading('moved_distance') is None
            page.dismiss_notices()
            wait_for_robot(page)
    publisher.unregister()


def test_a_scan_is_drawn_where_there_is_one(master, browser):
    """As dots on the walls of the room, which the page itself does not draw."""
    def colour(page):
        red, green, blue = page.scene().astype(int).transpose(2, 0, 1)
        return ((red - green > 80) & (blue - green > 60)).sum()

    room = f'_world:={ROOT}/sim_turtlebot/worlds/room.urdf'
    with rosrun('sim_turtlebot', 'sim_turtlebot_node.py', '__ns:=seeing', '_scan:=true', room), \
            View('__ns:=seeing') as view, browser.open(view.url) as page:
        wait_until(lambda: colour(page) > SCAN_PIXELS, TIMEOUT, 'a scan in the picture')
    with rosrun('sim_turtlebot', 'sim_turtlebot_node.py', '__ns:=blind', room), \
            View('__ns:=blind') as view, browser.open(view.url) as page:
        page.dismiss_notices()
        wait_for_robot(page)
        assert colour(page) < SCAN_PIXELS / 10


def test_odometry_that_is_off_is_drawn_as_a_ghost(master, browser):
    """Slipping wheels: blue where the robot believes it is, dark where it really is."""
    with rosrun('sim_turtlebot', 'sim_turtlebot_node.py', '__ns:=slippery',
                '_odometry_source:=encoder', '_wheel_slip:=0.4', '_cmd_vel_timeout:=0'), \
            View('__ns:=slippery') as view, browser.open(view.url) as page:
        motion = Motion('/slippery/')
        page.wait_for_reading('speed', lambda speed: speed == 0)
        page.dismiss_notices()
        wait_for_robot(page)
        assert blue_pixels(page.scene()) < ROBOT_PIXELS / 10
        page.hold('forward')
        page.wait_for_reading('true_distance', lambda metres: metres > 0.5)
        page.release()
        motion.wait_until_resting()
        page.wait_for_reading('speed', lambda speed: speed == 0)
        wait_until(lambda: blue_pixels(page.scene()) > ROBOT_PIXELS, TIMEOUT,
                   'a blue robot beside the dark one')


def test_a_robot_is_put_where_the_page_says(master, browser):
    """Typed, as numbers with a sign and a point."""
    with rosrun('sim_turtlebot', 'sim_turtlebot_node.py', '__ns:=put'), \
            View('__ns:=put') as view, browser.open(view.url) as page:
        motion = Motion('/put/')
        page.unfold('put the robot')
        for label, text in ('x (m)', '1.5'), ('y (m)', '-0.25'), ('heading (degrees)', '-90'):
            page.type(label, text)
        page.click('put here')
        motion.wait_for(lambda m: place(m) == (1.5, -0.25, -1.57), what='a robot that was put')
        page.wait_for_reading('heading', lambda degrees: degrees == pytest.approx(-90))
        assert 'ignored' not in view.process.output


def test_all_robots_of_a_world_are_shown_and_each_can_be_driven(master, browser):
    """The pad drives the one that is chosen, and no other."""
    with rosrun('sim_turtlebot', 'sim_turtlebot_node.py', '__ns:=pair', '_robots:=2',
                '_cmd_vel_timeout:=0'), View('__ns:=pair') as view:
        first, second = Motion('/pair/robot_1/'), Motion('/pair/robot_2/')
        with browser.open(view.url) as page:
            page.choose('robot', 'robot_2')
            page.hold('forward')
            page.wait_for_reading('true_distance', lambda metres: metres > 0.01)
            second.commands.wait_for_publisher()
            page.release()
            second.wait_until_stopped()
    assert not first.commands.messages


def blue_pixels(picture):
    """Return how many pixels are more blue than anything else."""
    red, _, blue = numpy.moveaxis(picture, 2, 0)
    return (blue - red > 40).sum()
