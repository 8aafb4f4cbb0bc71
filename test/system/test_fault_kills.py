"""Processes that are killed without warning, and come back."""

import os
import signal

import pytest
import rosgraph
from odometry_tests.links import pid_of
from odometry_tests.processes import Master, Process
from odometry_tests.tutorial import (
    LONGEST_STEP,
    Distance,
    Truth,
    detector,
    mover,
    simulator,
    simulator_in_step,
)
from odometry_tests.waiting import wait_until

FAR = '_distance:=1000'  # m; no test lasts until there

pytestmark = pytest.mark.usefixtures('simulated_time')


def kill(process):
    process.send(signal.SIGKILL)
    process.wait()


def test_nodes_survive_a_killed_simulator_and_drive_its_successor(master):
    moved = Distance()
    with detector() as counter, mover(FAR) as driver:
        with simulator_in_step('_real_time_factor:=3') as first:
            moved.wait_for(lambda m: m.data > 0.3, what='0.3 m')
            kill(first)
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


@pytest.mark.nightly
def test_the_graph_goes_on_without_its_master(monkeypatch):
    for variable in 'ROS_MASTER_URI', 'ROS_HOSTNAME':  # which the master of this test sets
        monkeypatch.setenv(variable, os.environ[variable])
    with Master(use_sim_time=True) as own, simulator('_real_time_factor:=3') as robot, \
            detector() as counter, mover(FAR) as driver, \
            Process('rostopic', 'echo', '-p', '/base_pose_ground_truth/twist/twist/linear/x') as speeds:
        wait_until(lambda: moving(speeds), 20.0, 'a moving robot')
        own.end(signal.SIGINT, timeout=20.0)
        wait_until(lambda: not rosgraph.is_master_online(), 5.0, 'a master that is gone')
        before = moving(speeds)
        wait_until(lambda: moving(speeds) > before + 100, 20.0, 'a robot that goes on')
        for process in (driver, counter, robot):
            assert process.end() == 0, process.output


def moving(speeds):
    """Return how many messages of a moving robot `rostopic echo -p` has printed."""
    values = [line.split(',')[1] for line in speeds.stdout.splitlines() if line[:1].isdigit()]
    return sum(float(value) > 0.05 for value in values)
