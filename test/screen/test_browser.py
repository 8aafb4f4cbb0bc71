"""What the browser window shows, in a real browser: robots, numbers, plots."""

import pytest
import rosgraph
from odometry_tests.processes import rosrun
from odometry_tests.viewing import ROBOT_PIXELS, dark_pixels, wait_for_robot
from odometry_tests.waiting import TIMEOUT, wait_until


def viewers(topic='/odom'):
    """Return the viewers that subscribe to a topic."""
    _, subscriptions, _ = rosgraph.Master('/test').getSystemState()
    return [node for node in dict(subscriptions).get(topic, []) if node.startswith('/view')]


def test_a_page_without_a_robot_says_what_it_waits_for(page):
    """The floor is there, and nothing on it."""
    page.wait_for_text('waiting for odometry on /odom')
    page.dismiss_notices()
    scene = page.scene()
    assert scene.std() > 1, 'the picture is blank'
    assert len(dark_pixels(scene)[0]) < ROBOT_PIXELS / 10
    assert page.reading('moved_distance') is None


def test_the_page_shows_the_robot_drive_two_metres(robot, page):
    """From the start mark to the two-metre mark, in numbers and in the picture."""
    page.wait_for_reading('moved_distance', lambda metres: metres == 0)
    page.dismiss_notices()
    rows, columns = wait_for_robot(page)
    with rosrun('test_movement', 'test_movement.py', '_speed:=0.5',
                '_exit_when_done:=true') as mover:
        page.wait_for_reading('moved_distance', lambda metres: metres >= 2.0)
        assert mover.wait() == 0, mover.output
    robot.wait_until_resting()
    went = pytest.approx(robot.last.pose.pose.position.x, abs=0.002)
    page.wait_for_reading('moved_distance', lambda metres: metres == went)
    page.wait_for_reading('true_distance', lambda metres: metres == went)
    page.wait_for_reading('real_time_factor', lambda rate: rate > 0)
    with robot.paused():
        wait_for_robots_time(page, robot)
    # Two metres are about half the width of what the camera sees.
    wait_for_robot(page, lambda end_rows, end_columns: end_columns.mean() - columns.mean() > 75
                   and abs(end_rows.mean() - rows.mean()) < 15)


def wait_for_robots_time(page, robot):
    """Return once the page shows the time of a paused robot, to a tenth of a second."""
    page.wait_for_reading('simulated_time',
                          lambda seconds: seconds == pytest.approx(robot.stamp, abs=0.051))


def test_two_pages_show_the_same(robot, browser, view, page):
    """The second one can go and the first one goes on."""
    with browser.open(view.url) as second:
        start = wait_for_the_same_distance(page, second)
        second.hold('back')
        page.wait_for_reading('moved_distance', lambda metres: metres > start + 0.1)
        second.release()
        robot.wait_until_resting()
        moved = wait_for_the_same_distance(page, second)
    page.hold('forward')
    page.wait_for_reading('moved_distance', lambda metres: metres > moved + 0.1)
    page.release()
    robot.wait_until_resting()


def wait_for_the_same_distance(page, second):
    """Return the distance that both pages show."""
    return second.wait_for_reading('moved_distance',
                                   lambda metres: metres == page.reading('moved_distance'))


def test_the_page_shows_a_heading_and_its_target(robot, page):
    """The P-controller's target is drawn beside the heading."""
    page.wait_for_reading('heading', lambda degrees: abs(degrees) < 90)
    with rosrun('rotate_robot', 'rotate.py', '_target:=30', '_kp:=1') as rotator:
        page.wait_for_text('target')
        page.wait_for_reading('heading', lambda degrees: degrees == pytest.approx(30, abs=2))
        assert rotator.end() == 0, rotator.output


def test_the_buttons_pause_resume_and_reset_the_simulation(robot, page):
    """A paused robot says nothing; a reset one is where it began."""
    page.wait_for_text('pause')
    page.wait_for_reading('real_time_factor', lambda rate: rate > 0)
    page.click('pause')
    page.wait_for_reading('real_time_factor', lambda rate: rate == 0)
    wait_for_robots_time(page, robot)
    page.click('resume')
    page.wait_for_reading('real_time_factor', lambda rate: rate > 0)
    robot.clear()
    page.click('reset')
    start = robot.wait_for(lambda m: m.header.seq == 0, what='a robot that begins anew')
    assert abs(start.pose.pose.position.x) < 1e-3
    page.wait_for_reading('true_distance', lambda metres: metres == 0)
    with robot.paused():
        wait_for_robots_time(page, robot)


def test_nobody_listens_while_no_page_is_open(robot, page):
    """The simulation then pays for no subscriber."""
    wait_until(viewers, TIMEOUT, 'a viewer on /odom')
    page.close()
    for topic in ('/odom', '/base_pose_ground_truth', '/joint_states', '/moved_distance'):
        wait_until(lambda topic=topic: not viewers(topic), TIMEOUT, f'no viewer on {topic}')
    assert not viewers('/clock')
