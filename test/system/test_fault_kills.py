"""Processes that are killed without warning, and come back."""

import os
import signal

import pytest
from odometry_tests.links import pid_of
from odometry_tests.processes import Process
from odometry_tests.tutorial import (
    LONGEST_STEP,
    Distance,
    Truth,
    detector,
    mover,
    simulator_in_step,
)

FAR = '_distance:=1000'  # m; no test lasts until there

pytestmark = pytest.mark.usefixtures('simulated_time')


def test_nodes_survive_a_killed_simulator_and_drive_its_successor(master):
    moved = Distance()
    with detector() as counter, mover(FAR) as driver:
        with simulator_in_step('_real_time_factor:=3') as first:
            moved.wait_for(lambda m: m.data > 0.3, what='0.3 m')
            first.send(signal.SIGKILL)
            first.wait()
        before = moved.last.data
        with simulator_in_step('_real_time_factor:=3'):
            moved.wait_for(lambda m: m.data > before + 0.3, what='0.3 m more')
            assert counter.running and driver.running
    assert max(moved.steps) < LONGEST_STEP, 'a jump was counted'
    assert min(moved.steps) >= 0, 'distance was lost'


def test_the_launch_ends_when_the_simulator_dies(master):
    with Process('roslaunch', 'odometry_launch', 'move_two_meters.launch',
                 'real_time_factor:=3') as launch:
        Truth().wait_until_moving(30.0)
        os.kill(pid_of('/sim_turtlebot'), signal.SIGKILL)
        launch.wait(30.0)
    assert 'REQUIRED process' in launch.output
