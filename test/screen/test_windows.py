"""RViz and PyBullet's window, on a screen that nobody sees."""

import shutil

import pytest
from odometry_tests.processes import Process
from odometry_tests.tutorial import Truth
from odometry_tests.waiting import wait_until
from PIL import ImageGrab

DRAWN = 100  # colours on a screen on which a robot has been drawn

pytestmark = [pytest.mark.nightly, pytest.mark.usefixtures('simulated_time')]


@pytest.fixture
def screen(monkeypatch):
    if not shutil.which('Xvfb'):
        pytest.skip('Xvfb is not installed')
    with Process('Xvfb', '-displayfd', '1', '-screen', '0', '800x600x24', '+extension', 'GLX', '-noreset') as server:
        wait_until(lambda: server.stdout, 10.0, lambda: server.output)
        monkeypatch.setenv('DISPLAY', f':{server.stdout}')
        monkeypatch.setenv('LIBGL_ALWAYS_SOFTWARE', '1')
        yield f':{server.stdout}'


@pytest.mark.parametrize('argument', ['rviz:=true', 'gui:=true'])
def test_a_window_shows_the_robot_and_ends_cleanly(screen, argument):
    if 'rviz' in argument and not shutil.which('rviz'):
        pytest.skip('rviz is not installed')

    def colours():
        return len(ImageGrab.grab(xdisplay=screen).getcolors(2**24))

    with Process('roslaunch', 'odometry_launch', 'move_two_meters.launch', argument) as launch:
        Truth().wait_for(timeout=40.0, what='odometry')
        wait_until(lambda: colours() > DRAWN, 30.0, lambda: (
            f'the robot; there are {colours()} colours, and it printed:\n{launch.output}'))
        assert launch.end() == 0, launch.output
    assert 'has died' not in launch.output
