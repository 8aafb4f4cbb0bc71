"""The page and its clients: strangers, and what no browser would send."""

import contextlib
import math
import signal
from urllib.error import HTTPError
from urllib.request import Request, urlopen

import pytest
import rosgraph
import rospy
from geometry_msgs.msg import Twist
from odometry_tests.robots import place
from odometry_tests.tutorial import Truth, simulator
from odometry_tests.waiting import TIMEOUT, Recorder, wait_until
from sim_turtlebot.lockstep.threads import Thread
from std_msgs.msg import Empty, String
from std_srvs.srv import Trigger
from viewer import viewing

pytest.importorskip('page_client', reason='viser is not installed')
from page_client import ROBOTS, PageClient, open_page, published


@pytest.fixture(scope='module')
def view(master):
    with published('/strange'), viewing('__ns:=/strange', patient=True) as running, open_page(running):
        yield running
    assert 'Traceback' not in running.output


@pytest.fixture
def commands():
    return {robot: Recorder(f'/strange/{robot}/cmd_vel', Twist) for robot in ROBOTS}


def drive(page, recorder, label='forward'):
    """Hold a button until the first command to move; return it once the robot has been stopped."""
    recorder.clear()
    command = wait_until(
        lambda: page.hold(label) or next(filter(Twist().__ne__, recorder.messages), None),
        TIMEOUT, 'a command', period=0.05)
    page.set(label, True)
    wait_until(lambda: recorder.last == Twist(), TIMEOUT, 'the zero of a release')
    return command


@pytest.mark.parametrize('ends', ['page', 'viewer'])
def test_a_page_or_a_viewer_that_ends_in_mid_drive_stops_the_robot(master, ends):
    """Nobody is left to release the button."""
    recorder = Recorder('/left/robot_1/cmd_vel', Twist)
    with published('/left'), viewing('__ns:=left', patient=True) as view, open_page(view) as page:
        wait_until(lambda: page.hold('forward') or recorder.messages, TIMEOUT, 'a command', period=0.05)
        page.close() if ends == 'page' else view.end(signal.SIGTERM)
        recorder.wait_for(lambda m: m == Twist(), what='zero')
        assert recorder.last == Twist()


def driven():
    topics, _, _ = rosgraph.Master('/test').getSystemState()
    return {topic for topic, _ in topics if topic.endswith('cmd_vel')}


def test_only_its_own_names_get_the_page_and_nobody_may_frame_it(view):
    """A click that was meant for the page around the frame would drive."""
    url = f'http://localhost:{view.port}'
    with urlopen(url) as answer:
        assert b'viser' in answer.read().lower()
        assert answer.headers['Content-Security-Policy'] == "frame-ancestors 'self'"
    with pytest.raises(HTTPError, match='403'):
        urlopen(Request(url, headers={'Host': f'evil.example:{view.port}'}))


@pytest.mark.parametrize('slider, button, value, expected', [
    ('speed (m/s)', 'forward', 1e9, 0.7), ('speed (m/s)', 'forward', -5, 0.05),
    ('speed (m/s)', 'forward', '[]', 0.2), ('turn (deg/s)', 'left', 1e9, math.pi)])
def test_a_command_stays_within_the_ends_of_the_slider(view, commands, slider, button, value, expected):
    """A value that viser cannot convert changes nothing."""
    with open_page(view) as page:
        page.set(slider, value)
        command = drive(page, commands['robot_1'], button)
        page.set(slider, {'forward': 0.2, 'left': 45.0}[button])
    assert command.linear.x + command.angular.z == pytest.approx(expected)


def test_a_speed_that_is_no_number_never_drives(view, commands):
    recorder = commands['robot_1']
    with open_page(view) as page:
        page.set('speed (m/s)', math.nan)
        assert wait_until(lambda: page.hold('forward') or recorder.last, TIMEOUT, 'a command') == Twist()
        page.set('speed (m/s)', 0.2)
        drive(page, recorder)


@pytest.mark.parametrize('value', ['robot_3', 1])
def test_only_listed_robots_are_driven(view, commands, value):
    with open_page(view) as page:
        page.set('robot', 'robot_2')
        drive(page, commands['robot_2'])
        page.set('robot', value)
        drive(page, commands['robot_1'])
    assert driven() <= {f'/strange/{robot}/cmd_vel' for robot in ROBOTS}


def test_while_no_robot_is_listed_none_is_driven(master):
    """The page is there before the first robot, and the root of the namespace is no robot."""
    recorder = Recorder('/left/robot_1/cmd_vel', Twist)
    with viewing('__ns:=left', patient=True) as view, contextlib.closing(PageClient(view.port)) as page:
        page.show()
        for _ in range(10):
            page.hold('forward')
        with published('/left'):
            page.find('robot')
            drive(page, recorder)
            assert '/left/cmd_vel' not in driven()


def test_a_page_that_is_shown_does_not_call_time_sleep(view):
    """Lockstep would name it, as a node that acts by wall time."""
    with open_page(view), contextlib.closing(Thread(view.pid, view.pid, False)) as main:
        begin, states = main.sleep_count, []
        wait_until(lambda: states.append(main.check_asleep() and main.sleeps_by_wall_time)
                   or main.sleep_count > begin + 10, TIMEOUT, 'ten naps')
    assert not any(states)


def test_the_simulators_warning_is_shown_as_long_as_it_is_there(view):
    """As text, not as HTML."""
    publisher = rospy.Publisher('/strange/sim_turtlebot/warning', String, queue_size=1, latch=True)
    publisher.publish('too <b>slow')
    with open_page(view) as page:
        page.wait_for_text('too &lt;b&gt;slow')
        publisher.unregister()
        page.wait_for_text('no simulator here')


def test_the_chosen_robot_is_put_where_the_page_says_and_a_simulation_is_paused_and_reset(master):
    with simulator('__ns:=placed', '_robots:=2') as world, viewing('__ns:=placed') as view, \
            open_page(view) as page:
        first, second = (Truth(f'/placed/{robot}/') for robot in ROBOTS)
        distance_reset = Recorder('/placed/robot_2/moved_distance/reset', Empty)
        first.wait_for(what='robot_1')
        second.wait_for(what='robot_2')
        for robot, pose, is_done in (
                ('robot_1', [1e9, 0.0, 0.0], lambda: 'x is 1e+09 m' in world.output),
                ('robot_2', [3.0, -1.5, 90], lambda: place(second.last) == (3.0, -1.5, 1.57))):
            page.set('robot', robot)
            page.set('x, y (m), heading (degrees)', pose)
            page.set('put here', True)
            wait_until(is_done, TIMEOUT, f'{robot} that is put at {pose}, or a refusal')
        assert {place(message) for message in first.messages} == {(0.0, 0.0, 0.0)}
        step = rospy.ServiceProxy('/placed/sim_turtlebot/step', Trigger)
        page.set('simulation', 'pause')
        wait_until(lambda: step().success, TIMEOUT, 'a simulation that is paused')
        page.set('simulation', 'reset')
        second.wait_for(lambda m: place(m) == (0.0, 1.0, 0.0) and m.header.seq == 0, what='a new start')
        distance_reset.wait_for()
        page.set('simulation', 'resume')
        wait_until(lambda: not step().success, TIMEOUT, 'a simulation that runs')
