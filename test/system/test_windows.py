"""RViz and PyBullet's window, on a screen that nobody sees."""

import shutil
import subprocess

import numpy
import pytest
import rosgraph
from odometry_tests.processes import Process
from odometry_tests.tutorial import Truth
from odometry_tests.waiting import wait_until

SIZE = (800, 600)
DEAD_CONNECTION_TIMEOUT = 20.0  # s


@pytest.fixture(autouse=True)
def simulated_time(master):
    """Let the nodes follow the simulator's clock."""
    rosgraph.Master('/test').setParam('/use_sim_time', True)


@pytest.fixture
def screen(monkeypatch, tmp_path):
    """Start an X server without a screen and let everything draw there."""
    if not shutil.which('Xvfb'):
        pytest.skip('Xvfb is not installed')
    number, folder = 71, tmp_path
    with Process('Xvfb', f':{number}', '-screen', '0', f'{SIZE[0]}x{SIZE[1]}x24',
                 '+extension', 'GLX', '-fbdir', folder) as server:
        monkeypatch.setenv('DISPLAY', f':{number}')
        monkeypatch.setenv('LIBGL_ALWAYS_SOFTWARE', '1')
        frame = folder / 'Xvfb_screen0'
        wait_until(lambda: frame.exists() and server.running, 10.0, 'an X server')
        yield frame


def colours(frame):
    """Return how many different colours there are on the screen, kept by Xvfb in a XWD file."""
    data = frame.read_bytes()
    header = int.from_bytes(data[:4], 'big') + 12 * int.from_bytes(data[76:80], 'big')
    pixels = numpy.frombuffer(data[header:header + 4 * SIZE[0] * SIZE[1]], dtype=numpy.uint32)
    return len(numpy.unique(pixels))


def test_rviz_shows_the_robot_and_ends_cleanly(screen):
    """With our configuration: robot model, odometry, truth, and no complaint."""
    if subprocess.run(['rospack', 'find', 'rviz'], capture_output=True, check=False).returncode:
        pytest.skip('rviz is not installed')
    with Process('roslaunch', 'odometry_launch', 'move_two_meters.launch', 'rviz:=true') as launch:
        Truth().wait_until_moving(40.0)
        wait_until(lambda: colours(screen) > 100, 30.0, lambda: f'{colours(screen)} colours')
        assert launch.end(timeout=30.0) == 0, launch.output
    assert 'Traceback' not in launch.output
    assert 'has died' not in launch.output


def test_the_window_of_the_physics_shows_the_robot(screen):
    """gui:=true draws, and Ctrl-C ends it as without a window."""
    with Process('roslaunch', 'odometry_launch', 'sim.launch', 'gui:=true') as launch:
        Truth().wait_for(timeout=40.0)
        wait_until(lambda: colours(screen) > 100, 30.0, lambda: f'{colours(screen)} colours')
        assert launch.end(timeout=30.0) == 0, launch.output
    assert 'has died' not in launch.output


def test_closing_the_window_ends_the_simulator_cleanly(screen):
    """A window manager cuts the connection of a program whose window is closed."""
    if not shutil.which('xkill'):
        pytest.skip('xkill is not installed')
    with Process('rosrun', 'sim_turtlebot', 'sim_turtlebot_node.py', '_gui:=true') as node:
        Truth().wait_for(timeout=40.0)
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
