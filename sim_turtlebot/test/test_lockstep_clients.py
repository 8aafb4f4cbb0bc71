"""Lockstep waits for nodes as others write them, whatever they wait for themselves."""

import os
import random
import sys
from functools import partial

import pytest
from geometry_msgs.msg import Twist
from lockstep_runs import (
    CLIENTS_FOLDER,
    NOT_AWAITED,
    RUN_TIME,
    UNPACED,
    assert_same_bytes,
    compile_client,
    record,
    started_client,
    step,
)
from nav_msgs.msg import Odometry
from odometry_tests.pausing import call
from odometry_tests.processes import assert_refused
from odometry_tests.tutorial import Truth, simulator, simulator_in_step
from odometry_tests.waiting import Recorder
from tf2_msgs.msg import TFMessage

# The nodes beside the simulator, the first of which commands; C++ is compiled from client.cpp.
CLIENTS = {
    'rospy.wait_for_message': ['wait_for_message'], 'tf': ['tf_listener'], 'tf2_ros': ['tf2_listener'],
    'actionlib': ['action', 'action_server'],
    'subprocess': ['odd program'], 'multiprocessing': ['odd processes'],
    'ros::Rate': ['C++ rate'], 'ros::Timer': ['C++ timer'],
    'ros::MultiThreadedSpinner': ['C++ spinners']}
for graph in range(200):
    nodes = random.Random(graph).randint(2, 8)
    CLIENTS[f'random graph {graph}'] = [f'random_node {graph} {node} {nodes}' for node in range(nodes)]
BY_DAY = 'tf2_ros', 'subprocess'
CLIENT_TIME = 3  # s of simulated time
LEAST_COMMANDS = 5

pytestmark = pytest.mark.usefixtures('simulated_time')


@pytest.fixture(scope='module')
def start_client(tmp_path_factory):
    """Return a function that starts a node of a kind, with a name; C++ is compiled at its first use."""
    folder = tmp_path_factory.mktemp('clients')

    def start(kind, name):
        family, _, argument = kind.partition(' ')
        if family == 'C++':
            command = compile_client(folder / 'client'), argument
        elif family == 'odd':
            command = sys.executable, CLIENTS_FOLDER / 'odd_clients.py', argument
        else:
            command = sys.executable, CLIENTS_FOLDER / 'clients.py', kind
        return started_client(*command, f'__name:={name}')

    return start


@pytest.mark.parametrize('client', [
    pytest.param(client, marks=[] if client in BY_DAY else pytest.mark.nightly) for client in CLIENTS])
def test_two_runs_with_any_nodes_are_the_same_bytes(client, start_client):
    """Whatever they wait for: the clock, a message, a service, a transform; with the default clock."""
    starts = [partial(start_client, kind, f'client_{number}') for number, kind in enumerate(CLIENTS[client])]
    topics = {'/odom': (Odometry, 20 * CLIENT_TIME), '/tf': (TFMessage, 20 * CLIENT_TIME),
              '/cmd_vel': (Twist, LEAST_COMMANDS)}
    assert_same_bytes(*(record(starts, topics, ['_clock_rate:=100']) for _ in range(2)))


@pytest.mark.parametrize('rate', [30, 100])
def test_a_loop_keeps_its_rate(rate, start_client):
    commands, counts = Recorder('/cmd_vel', Twist), []
    with simulator('_lockstep:=true', UNPACED, '_paused:=true'), start_client(f'rate {rate}', 'client'):
        commands.wait_for_publisher()
        for seconds in 1, 5:
            step(20 * seconds)
            counts.append(len(commands.messages))
    # A command of either moment may have come before or after this thread looked.
    assert abs(counts[1] - counts[0] - 5 * rate) <= 1 + rate / 10, counts


@pytest.mark.parametrize('arguments', [[], ['_paused:=true']], ids=['running', 'paused'])
def test_time_stands_still_while_a_connection_is_made(arguments, start_client):
    with simulator_in_step(UNPACED, *arguments), start_client('rate', 'bystander'), \
            start_client('odd held_up', 'client') as client:
        client.wait_for_output('subscribed')
        if arguments:
            call('unpause_physics')
        client.wait_for_output('went on for')
        assert float(client.stdout.split()[-1]) <= 0.1, client.stdout  # two periods of the odometry


# A node that is busy before it has registered may be as busy as one that starts: 30 s.
BUSY, SLEEPS, STOPPED = 'it has been busy for', 'it acts by wall time', 'it has been stopped'
# What lockstep says of nodes that it cannot wait for, at any pace.
NAMED = {
    'odd busy': BUSY, 'odd busy_thread': BUSY, 'odd flood': BUSY,
    'odd wall 0.03': SLEEPS, 'odd wall 0.5': SLEEPS, 'odd wall 2': SLEEPS,
    'odd selecting': SLEEPS, 'odd wall_timer': SLEEPS, 'C++ usleep': SLEEPS,
    'odd stopped': STOPPED}
NAMED_BY_DAY = 'odd wall 0.5', 'odd flood', 'odd stopped'


@pytest.mark.parametrize('pace', [0, pytest.param(5, marks=pytest.mark.nightly)])
@pytest.mark.parametrize('kind', [
    pytest.param(kind, marks=[] if kind in NAMED_BY_DAY else pytest.mark.nightly) for kind in NAMED])
def test_who_cannot_be_waited_for_is_named_once_and_time_goes_on(kind, pace, start_client):
    with start_client('rate', 'bystander'), start_client(kind, 'culprit'), \
            simulator('_lockstep:=true', '_cpu_budget:=2', f'_real_time_factor:={pace}') as simulation:
        simulation.wait_for_output(
            f'{NOT_AWAITED} /culprit, so two runs may differ: {NAMED[kind]}', RUN_TIME)
        truth = Truth()
        truth.wait_seconds(10.0)
        assert simulation.output.count(NOT_AWAITED) == 1, simulation.output


def test_a_node_that_computes_is_waited_for_and_one_that_floods_is_not(start_client):
    """With the default budget; a scan of gmapping's takes more than two seconds."""
    with simulator_in_step(UNPACED) as simulation, start_client('odd long', 'client'):
        Recorder('/cmd_vel', Twist).wait_for_count(2, RUN_TIME)
        with start_client('odd flood', 'culprit'):
            simulation.wait_for_output(f'{NOT_AWAITED} /culprit, so two runs may differ: {BUSY} 2 s', RUN_TIME)
    assert simulation.output.count(NOT_AWAITED) == 1, simulation.output


def test_a_caller_that_asks_without_a_pause_does_not_hold_time(start_client):
    with simulator_in_step(UNPACED), start_client('odd flood_service', 'caller'):
        Truth().wait_seconds(1.0)


@pytest.mark.parametrize('arguments', [[], ['_lockstep:=true']], ids=['paced', 'lockstep'])
def test_commands_of_a_publisher_that_does_not_give_its_name_are_obeyed(arguments, start_client):
    with simulator(*arguments) as simulation, start_client('odd nameless', 'client'):
        Truth().wait_until_moving()
    assert 'Traceback' not in simulation.output, simulation.output


def test_the_publishers_of_two_clocks_are_named(ns, simulated_time):
    with simulator('__ns:=a') as first, simulator('__ns:=b'):
        first.wait_for_output('/clock is published by /a/sim_turtlebot and /b/sim_turtlebot: stop all but one; '
                              'for two robots use robots:=2')


def test_lockstep_without_psutil_is_refused(tmp_path, simulated_time):
    (tmp_path / 'psutil.py').write_text("raise ModuleNotFoundError(name='psutil')")
    path = os.pathsep.join([str(tmp_path), os.environ['PYTHONPATH']])
    with simulator('_lockstep:=true', env={'PYTHONPATH': path}) as simulation:
        assert_refused(simulation, 'lockstep needs psutil: install python3-psutil')


def test_a_command_before_time_zero_is_said_to_be_ignored(start_client):
    """Once: a node that sends only this one would wait for ever."""
    with simulator_in_step('_paused:=true') as simulation, start_client('odd early', 'client'):
        simulation.wait_for_output('lockstep ignores commands before time zero: wait for the first /odom')
