"""RViz and PyBullet's window, on a screen that nobody sees."""

import contextlib
import shutil
import subprocess

import pytest
import rosgraph
import rosnode
import rospy
from odometry_tests.pausing import call
from odometry_tests.processes import Process
from odometry_tests.screen import Screen
from odometry_tests.tutorial import Truth
from odometry_tests.waiting import Recorder, wait_until
from tf2_msgs.msg import TFMessage

DEAD_CONNECTION_TIMEOUT = 20.0  # s
FRAMES = {'odom', 'base_link', 'wheel_left_link'}

pytestmark = pytest.mark.usefixtures('simulated_time')


@pytest.fixture
def screen():
    if not shutil.which('Xvfb'):
        pytest.skip('Xvfb is not installed')
    with Screen(800, 600) as virtual:
        yield virtual


def partners(topic):
    """Return the nodes that publish a topic, and those that subscribe to it."""
    published, subscribed, _ = rosgraph.Master('/test').getSystemState()
    return dict(published).get(topic), dict(subscribed).get(topic)


def senders(recorders):
    """Return each frame that was recorded, with the name of the node that sent it."""
    return {(frame.child_frame_id, message._connection_header['callerid'])
            for recorder in recorders for message in recorder.messages
            for frame in message.transforms}


def wait_for_odometry(process):
    """Return once the process has a robot."""
    truth = Truth()
    wait_until(lambda: truth.last, 40.0, lambda: f'odometry; it printed:\n{process.output}')


def wait_for_robot(screen, process):
    """Return once as many colours as a robot has are on the screen that a process draws on."""
    wait_until(lambda: screen.colours() > 100, 30.0, lambda: (
        f'the robot; there are {screen.colours()} colours, and it printed:\n{process.output}'))


def test_rviz_shows_the_robot_and_ends_cleanly(screen):
    """With our configuration, without a complaint; each frame comes from one node."""
    if subprocess.run(['rospack', 'find', 'rviz'], capture_output=True, check=False).returncode:
        pytest.skip('rviz is not installed')
    with Process('roslaunch', 'odometry_launch', 'move_two_meters.launch', 'rviz:=true') as launch:
        recorders = [Recorder(topic, TFMessage) for topic in ('/tf', '/tf_static')]
        Truth().wait_until_moving(40.0)
        wait_for_robot(screen, launch)
        wait_until(lambda: FRAMES <= {frame for frame, _ in senders(recorders)}, 30.0,
                   lambda: f'{FRAMES}; there are {senders(recorders)}')
        assert partners('/initialpose') == (['/rviz'], ['/world_frame'])
        assert launch.end(timeout=30.0) == 0, launch.output
    assert 'has died' not in launch.output
    frames = [frame for frame, _ in senders(recorders)]
    assert len(frames) == len(set(frames)), senders(recorders)


def test_the_window_of_the_physics_shows_the_robot(screen):
    """gui:=true draws, also after a reset, and Ctrl-C ends it as without a window."""
    with Process('roslaunch', 'odometry_launch', 'sim.launch', 'gui:=true') as launch:
        wait_for_odometry(launch)
        with contextlib.suppress(rospy.ServiceException):  # a busy machine answers before it has reset
            call('reset_simulation')
        wait_for_robot(screen, launch)
        assert launch.end(timeout=30.0) == 0, launch.output
    assert 'has died' not in launch.output
    assert '/sim_turtlebot' not in rosnode.get_node_names(), 'it is still registered'


def test_closing_the_window_ends_the_simulator_cleanly(screen):
    """A window manager cuts the connection of a program whose window is closed."""
    if not shutil.which('xkill'):
        pytest.skip('xkill is not installed')
    with Process('rosrun', 'sim_turtlebot', 'sim_turtlebot_node.py', '_gui:=true') as node:
        wait_for_odometry(node)
        window = wait_until(bullet_window, 20.0, 'the window')
        assert Process('xkill', '-id', window).wait() == 0
        assert node.wait(DEAD_CONNECTION_TIMEOUT) == 0, node.output
    assert 'the window has been closed' in node.output


def bullet_window():
    """Return the X id of PyBullet's window, or None."""
    tree = subprocess.run(['xwininfo', '-root', '-tree'], capture_output=True, text=True,
                          check=False).stdout
    rows = [row.split()[0] for row in tree.splitlines() if 'Bullet' in row]
    return rows[0] if rows else None
