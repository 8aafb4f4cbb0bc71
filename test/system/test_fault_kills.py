"""Processes that are killed without warning, and come back."""

import os
import signal

import pytest
from odometry_tests.links import pid_of
from odometry_tests.processes import Process
from odometry_tests.tutorial import Truth, detector, mover, simulator_in_step
from odometry_tests.waiting import Recorder
from std_msgs.msg import Float64

LONGEST_STEP = 0.0055  # m in a period of the mover in lockstep, at its 0.1 m/s and 20 Hz; a tenth of it is margin

pytestmark = pytest.mark.usefixtures('simulated_time')


def test_nodes_survive_a_killed_simulator_and_drive_its_successor(master):
    moved = Recorder('moved_distance', Float64)
    with detector() as counter, mover('_distance:=1000') as driver:
        with simulator_in_step('_real_time_factor:=3') as first:
            moved.wait_for(lambda m: m.data > 0.3, what='0.3 m')
            first.send(signal.SIGKILL)
            first.wait()
        before = moved.last.data
        with simulator_in_step('_real_time_factor:=3'):
            moved.wait_for(lambda m: m.data > before + 0.3, what='0.3 m more')
            assert counter.running and driver.running
    distances = [message.data for message in moved.messages]
    steps = [after - before for before, after in zip(distances, distances[1:])]
    assert max(steps) < LONGEST_STEP, 'a jump was counted'


def test_the_launch_ends_when_the_simulator_dies(master):
    with Process('roslaunch', 'odometry_launch', 'move_two_meters.launch',
                 'real_time_factor:=3') as launch:
        Truth().wait_until_moving()
        os.kill(pid_of('/sim_turtlebot'), signal.SIGKILL)
        launch.wait(30.0)
    assert 'REQUIRED process' in launch.output
