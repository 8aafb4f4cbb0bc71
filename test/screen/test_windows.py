"""RViz and PyBullet's window, on a screen that nobody sees."""

import shutil

import pytest
from odometry_tests.processes import Process
from odometry_tests.tutorial import Truth
from odometry_tests.waiting import wait_until
from screen import colours, virtual_screen

DRAWN = 100  # colours on a screen on which a robot has been drawn

pytestmark = [pytest.mark.nightly, pytest.mark.usefixtures('simulated_time')]


@pytest.fixture
def screen():
    if not shutil.which('Xvfb'):
        pytest.skip('Xvfb is not installed')
    with virtual_screen():
        yield


def wait_for_odometry(process):
    truth = Truth()
    wait_until(lambda: truth.last, 40.0, lambda: f'odometry; it printed:\n{process.output}')


@pytest.mark.parametrize('argument', ['rviz:=true', 'gui:=true'])
def test_a_window_shows_the_robot_and_ends_cleanly(screen, argument):
    if 'rviz' in argument and not shutil.which('rviz'):
        pytest.skip('rviz is not installed')
    with Process('roslaunch', 'odometry_launch', 'move_two_meters.launch', argument) as launch:
        wait_for_odometry(launch)
        wait_until(lambda: colours() > DRAWN, 30.0, lambda: (
            f'the robot; there are {colours()} colours, and it printed:\n{launch.output}'))
        assert launch.end(timeout=30.0) == 0, launch.output
    assert 'has died' not in launch.output
