"""Two machines: network namespaces, joined by a cable that can be pulled out."""

import os
import shutil
import subprocess

import pytest
from odometry_tests.processes import Process
from odometry_tests.waiting import wait_until

ROBOT, DESK = 'odometry_robot', 'odometry_desk'
ADDRESSES = {ROBOT: '10.201.77.1', DESK: '10.201.77.2'}
CABLE = {ROBOT: 'odo_veth_a', DESK: 'odo_veth_b'}


def ip(*arguments):
    """Run iproute2's command."""
    subprocess.run(['ip', *arguments], check=True, capture_output=True, text=True)


@pytest.fixture
def machines():
    """Join two new network namespaces by a virtual cable."""
    if not shutil.which('ip'):
        pytest.skip('iproute2 is not installed')
    try:
        for machine in ADDRESSES:
            ip('netns', 'add', machine)
    except subprocess.CalledProcessError as error:
        pytest.skip(f'network namespaces need root: {error.stderr.strip()}')
    try:
        ip('link', 'add', CABLE[ROBOT], 'netns', ROBOT, 'type', 'veth',
           'peer', CABLE[DESK], 'netns', DESK)
        for machine, address in ADDRESSES.items():
            ip('-n', machine, 'addr', 'add', f'{address}/24', 'dev', CABLE[machine])
            ip('-n', machine, 'link', 'set', 'lo', 'up')
            ip('-n', machine, 'link', 'set', CABLE[machine], 'up')
        yield
    finally:
        for machine in ADDRESSES:
            ip('netns', 'delete', machine)


def on(machine, *command):
    """Start a command on a machine, with ROS between both of them."""
    environment = {**os.environ, 'ROS_MASTER_URI': f'http://{ADDRESSES[ROBOT]}:11311',
                   'ROS_IP': ADDRESSES[machine]}
    environment.pop('ROS_HOSTNAME', None)
    settings = [f'{name}={value}' for name, value in environment.items()]
    return Process('ip', 'netns', 'exec', machine, 'env', '-i', *settings, *command)


def values(echo):
    """Return the numbers that `rostopic echo -p` has printed."""
    return [float(line.split(',')[1]) for line in echo.stdout.splitlines()
            if not line.startswith('%')]


def test_two_metres_across_a_link_that_is_cut_for_three_seconds(machines):
    """The robot stops by its watchdog while the link is down, and ends at two metres."""
    with on(ROBOT, 'roscore') as master:
        master.wait_for_output('started core service', 30.0)
        assert on(ROBOT, 'rosparam', 'set', 'use_sim_time', 'true').wait(20.0) == 0
        with on(ROBOT, 'rosrun', 'sim_turtlebot', 'sim_turtlebot_node.py'), \
                on(DESK, 'rosrun', 'odom_movement_detector', 'odom_movement_detector.py'), \
                on(DESK, 'rosrun', 'test_movement', 'test_movement.py', '_speed:=0.2'), \
                on(ROBOT, 'rostopic', 'echo', '-p',
                   '/base_pose_ground_truth/twist/twist/linear/x') as speeds, \
                on(ROBOT, 'rostopic', 'echo', '-p',
                   '/base_pose_ground_truth/pose/pose/position/x') as positions:
            wait_until(lambda: values(positions)[-1:] > [0.5], 40.0, 'half a metre')
            ip('-n', ROBOT, 'link', 'set', CABLE[ROBOT], 'down')
            cut_at = len(values(speeds))
            wait_until(lambda: len(values(speeds)) >= cut_at + 60, 10.0, 'three seconds')
            stopped = values(speeds)[-1]
            ip('-n', ROBOT, 'link', 'set', CABLE[ROBOT], 'up')
            assert abs(stopped) < 1e-3, 'the robot drives on without a link'
            wait_until(lambda: values(positions)[-1:] >= [2.0], 60.0,
                       lambda: f'two metres; the robot is at {values(positions)[-1]}')
            wait_until(lambda: abs(values(speeds)[-1]) < 1e-3, 10.0, 'a robot at rest')
            assert values(positions)[-1] < 2.05
