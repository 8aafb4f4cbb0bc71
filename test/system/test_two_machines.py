"""Two machines: network namespaces, joined by a cable that can be pulled out."""

import contextlib
import os
import shutil
import subprocess

import pytest
from odometry_tests.processes import Process
from odometry_tests.scripts import ROOT
from odometry_tests.waiting import wait_until

# Names of this run alone: namespaces are the same for everybody on a machine. A cable's two ends
# are named inside them.
ROBOT, DESK = f'odometry_robot_{os.getpid()}', f'odometry_desk_{os.getpid()}'
ADDRESSES = {ROBOT: '10.201.77.1', DESK: '10.201.77.2'}
CABLE = 'cable'


def ip(*arguments):
    subprocess.run(['ip', *arguments], check=True, capture_output=True, text=True)


@pytest.fixture
def machines():
    """Join two new network namespaces by a virtual cable, with a ROS master in one of them."""
    if not shutil.which('ip'):
        pytest.skip('iproute2 is not installed')
    with contextlib.ExitStack() as made:
        try:
            join(made)
        except subprocess.CalledProcessError as error:
            pytest.skip(f'no virtual network can be made here: {error.stderr.strip()}')
        made.enter_context(on(ROBOT, 'env', '-u', 'ROS_IP', ROOT / 'ws', '--host', ADDRESSES[ROBOT],
                              'rosmaster', '--core'))
        wait_until(lambda: on(ROBOT, 'rosparam', 'set', 'use_sim_time', 'true').wait() == 0,
                   30.0, 'a ROS master')
        yield


def join(made):
    """Make the machines and the cable; what has been made is taken away with the stack `made`."""
    for machine in ADDRESSES:
        ip('netns', 'add', machine)
        made.callback(ip, 'netns', 'delete', machine)
        ip('netns', 'exec', machine, 'true')
    ip('link', 'add', CABLE, 'netns', ROBOT, 'type', 'veth', 'peer', CABLE, 'netns', DESK)
    for machine, address in ADDRESSES.items():
        ip('-n', machine, 'addr', 'add', f'{address}/24', 'dev', CABLE)
        ip('-n', machine, 'link', 'set', 'lo', 'up')
        ip('-n', machine, 'link', 'set', CABLE, 'up')


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


def echo(machine, topic, field):
    """Print a field of the messages on a topic, once it is published, seen from a machine.

    Plain rospy may never learn of a publisher that starts at the same moment.
    """
    def is_published():
        info = on(machine, 'rostopic', 'info', topic)
        return info.wait() == 0 and 'Publishers: None' not in info.stdout

    wait_until(is_published, 30.0, f'a publisher of {topic}', period=0.2)
    return on(machine, 'rostopic', 'echo', '-p', f'{topic}{field}')


def stands(positions):
    """Return whether a robot has stood for a second."""
    return len(set(values(positions)[-20:])) == 1


@pytest.mark.nightly
def test_two_metres_across_a_link_that_is_cut_for_three_seconds(machines):
    """The robot stops by its watchdog while the link is down, and ends at two metres."""
    with on(ROBOT, 'rosrun', 'sim_turtlebot', 'sim_turtlebot_node.py'), \
            on(DESK, 'rosrun', 'odom_movement_detector', 'odom_movement_detector.py'), \
            on(DESK, 'rosrun', 'test_movement', 'test_movement.py', '_speed:=0.2'), \
            echo(ROBOT, '/base_pose_ground_truth', '/pose/pose/position/x') as positions, \
            echo(DESK, '/cmd_vel', '/linear/x') as commands:
        wait_until(lambda: values(positions)[-1:] > [0.5], 40.0, 'half a metre')
        ip('-n', ROBOT, 'link', 'set', CABLE, 'down')
        cut_at = len(values(positions))
        wait_until(lambda: len(values(positions)) >= cut_at + 60, 10.0, 'three seconds')
        wait_until(lambda: stands(positions), 10.0, 'a robot that stops without a link')
        ip('-n', ROBOT, 'link', 'set', CABLE, 'up')
        wait_until(lambda: values(positions)[-1:] >= [2.0], 60.0,
                   lambda: f'two metres; the robot is at {values(positions)[-1]}')
        wait_until(lambda: values(commands)[-1:] == [0.0] and stands(positions), 10.0,
                   'a last command of zero, and a robot at rest')
