"""However a node that moves the robot ends, the robot stops, without a traceback."""

import os
import signal
import socket
import sys

import psutil
import pytest
import rosgraph
import rosnode
import rospy
from geometry_msgs.msg import Twist
from odometry_tests.linux import signals
from odometry_tests.pausing import moves_on
from odometry_tests.processes import Process, hold_port, rosrun
from odometry_tests.scripts import ROOT
from odometry_tests.tutorial import (
    Truth,
    detector,
    forget_parameters,
    heading,
    mover,
    rotator,
    simulator,
)
from odometry_tests.waiting import PATIENCE, TIMEOUT, Recorder, wait_until
from std_msgs.msg import Float64

STOPPING_TIME = 0.15  # s, to brake, from the pause in which the node ended

# A node whose main thread has no signal delivered while it waits for the master.
DEAF_WAIT = """
import signal, socket
import rosgraph
from odometry_common.node import run_node
def ask():
    signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
    print('waiting', flush=True)
    here, there = socket.socketpair()
    here.recv(1)
rosgraph.is_master_online = ask
run_node('deaf', print, '')
"""


def test_a_node_without_a_master_says_so_and_ends_at_once():
    """With parameters to upload too, which rospy answers with a traceback."""
    with hold_port() as port, rosrun(
            'test_movement', 'test_movement.py', '_speed:=0.2',
            env={'ROS_MASTER_URI': f'http://localhost:{port}'}) as node:
        node.wait_for_output('Unable to register with master node')
        assert node.running
        assert node.end(signal.SIGHUP, timeout=2.0) == 0


def test_a_node_that_nohup_starts_outlives_its_terminal():
    """As bare rospy does: its process ignores HUP."""
    with hold_port() as port, Process(
            'nohup', ROOT / 'ws', 'rosrun', 'test_movement', 'test_movement.py',
            env={'ROS_MASTER_URI': f'http://localhost:{port}'}) as node:
        node.wait_for_output('Unable to register with master node')
        assert signal.SIGHUP in signals(node.pid, 'SigIgn')


def test_the_simulator_ends_while_it_loads_a_world(master, tmp_path):
    os.mkfifo(tmp_path / 'pipe.obj')
    (tmp_path / 'world.urdf').write_text(
        '<robot name="r"><link name="a"><collision><geometry><mesh filename="pipe.obj"/></geometry>'
        '</collision></link></robot>')
    with simulator(f'_world:={tmp_path}/world.urdf') as node:
        wait_until(psutil.Process(node.pid).children, TIMEOUT, 'the process that tries the world')
        assert node.end(signal.SIGTERM) == 0, node.output
    assert not node.output.strip()


def test_a_node_whose_master_never_answers_ends_by_one_ctrl_c():
    """As behind an address that swallows what is sent there; rosgraph catches what Ctrl-C raises."""
    with socket.create_server(('localhost', 0)) as mute, rosrun(
            'test_movement', 'test_movement.py',
            env={'ROS_MASTER_URI': f'http://localhost:{mute.getsockname()[1]}'}) as node:
        mute.settimeout(TIMEOUT * PATIENCE)
        question, _ = mute.accept()
        with question:
            assert question.recv(1)
            assert node.end() == 0, node.output
    assert not node.output.strip()


def test_a_signal_that_comes_just_before_a_wait_ends_it():
    """As one that arrives between Python's last instruction and recv(); here another thread takes it."""
    with Process(sys.executable, '-c', DEAF_WAIT) as node:
        node.wait_for_output('waiting')
        assert node.end() == 0, node.output


def test_a_line_that_nobody_reads_any_more_ends_the_node_quietly(ns):
    commands = Recorder(f'{ns}cmd_vel', Twist)
    distances = rospy.Publisher(f'{ns}moved_distance', Float64, queue_size=100)
    pipeline = 'rosrun test_movement test_movement.py | true; echo "status ${PIPESTATUS[0]}"'
    with Process('bash', '-c', pipeline) as shell:
        wait_until(lambda: distances.get_num_connections(), TIMEOUT, 'a mover')
        commands.wait_for_publisher()
        wait_until(lambda: distances.publish(0.0) or not shell.running, TIMEOUT, 'its end')
        assert shell.wait() == 0, shell.output
    assert shell.output.split('\n') == ['status 0', '']
    commands.wait_for(lambda m: m == Twist(), what='zero at last')


@pytest.fixture(scope='module')
def truth(master):
    forget_parameters()
    rosgraph.Master('/test').setParam('/use_sim_time', True)
    with simulator('_cmd_vel_timeout:=0'), detector():
        recorder = Truth()
        recorder.wait_for(what='the robot')
        yield recorder
    rosgraph.Master('/test').setParam('/use_sim_time', False)


@pytest.fixture
def driver(request, truth):
    if request.param == 'mover':
        node = mover('__name:=driver', '_distance:=100')
    else:
        # Out of reach within the test: it turns at full speed limit all the time.
        node = rotator('__name:=driver', '_max_angular_speed:=0.2',
                       f'_target:={170 + heading(truth.last):.0f}')
    with node:
        truth.wait_until_moving()
        yield node
    truth.wait_until_resting()


@pytest.mark.parametrize('driver, ending', [
    ('mover', lambda node: node.send(signal.SIGINT)), ('rotator', lambda node: node.send(signal.SIGTERM)),
    ('mover', lambda node: node.send(signal.SIGHUP)), ('rotator', lambda _: rosnode.kill_nodes(['/driver']))],
    ids=['SIGINT', 'SIGTERM', 'SIGHUP', 'rosnode kill'], indirect=['driver'])
def test_the_robot_is_at_rest_at_once(driver, truth, ending):
    """The node's last command is zero; nothing else could stop this robot.

    Its time stands still meanwhile, on which the node must not wait. How long a busy machine takes
    to end a process is no matter.
    """
    commands = Recorder('cmd_vel', Twist)
    commands.wait_for()

    def end():
        ending(driver)
        assert driver.wait() == 0, driver.output
        wait_until(lambda: commands.last == Twist(), 10.0, 'zero as the last command')

    assert moves_on(truth, end) <= STOPPING_TIME
