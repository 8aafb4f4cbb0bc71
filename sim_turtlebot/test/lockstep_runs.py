"""Runs in lockstep, recorded and compared to the byte."""

import contextlib
import io
import signal
import subprocess

import rosgraph
import rosnode
import rospy
from odometry_tests.pausing import call
from odometry_tests.processes import Process
from odometry_tests.scripts import ROOT
from odometry_tests.tutorial import simulator_in_step
from odometry_tests.waiting import Recorder, wait_until
from sim_turtlebot.lockstep.lockstep import Lockstep
from std_srvs.srv import Trigger

CLIENTS_FOLDER = ROOT / 'sim_turtlebot/test'
RUN_TIME = 60.0  # s
NOT_AWAITED = 'lockstep does not wait for'
UNPACED = '_real_time_factor:=0'


@contextlib.contextmanager
def started_client(*command):
    """Start a client and kill it in the end, as Ctrl-C may hang any node of rospy.

    rospy's handler closes the connections, on the main thread: if this is in publish(), it already holds
    the lock that closing takes (rospy/impl/tcpros_pubsub.py, QueuedConnection). Or the handler waits for
    the answer of a node that has ended.
    """
    with Process(*command) as process:
        yield process
        process.send(signal.SIGKILL)
        process.wait()
    # Another server may have its address before the master forgets it.
    rosnode.cleanup_master_blacklist(rosgraph.Master('/test'), [command[-1].replace('__name:=', '/')])


def record(starts, topics, arguments=(), begin=lambda: call('unpause_physics')):
    """Run nodes in lockstep; return the messages on each topic, from time zero on.

    :param starts: functions that start the nodes beside the simulator
    :param topics: message class and number of messages by topic
    :param arguments: for the simulator
    :param begin: function that lets time pass
    """
    with contextlib.ExitStack() as stack:
        simulation = stack.enter_context(simulator_in_step(UNPACED, '_paused:=true', *arguments))
        for start in starts:
            stack.enter_context(start())
        # Closed, so that the next run's do not hear what comes late.
        recorders = {topic: stack.enter_context(contextlib.closing(Recorder(topic, kind)))
                     for topic, (kind, _) in topics.items()}
        for recorder in recorders.values():
            recorder.wait_for_publisher()
        with contextlib.closing(Lockstep(0.01, 20.0)) as graph:
            wait_until(graph.is_graph_stable, RUN_TIME, 'nodes at rest before time begins')
        for recorder in recorders.values():
            recorder.clear()
        begin()
        for topic, (_, count) in topics.items():
            recorders[topic].wait_for_count(count, RUN_TIME)
        call('pause_physics')  # a node that calls another's service meanwhile would print a traceback
        assert NOT_AWAITED not in simulation.output, simulation.output
        return {topic: recorders[topic].messages[:count] for topic, (_, count) in topics.items()}


def step(count):
    """Step a paused simulation so many times; return the answers."""
    rospy.wait_for_service('/sim_turtlebot/step')
    with contextlib.closing(rospy.ServiceProxy('/sim_turtlebot/step', Trigger, persistent=True)) as proxy:
        return [proxy() for _ in range(count)]


def bytes_of(message):
    buffer = io.BytesIO()
    message.serialize(buffer)
    return buffer.getvalue()


def assert_same_bytes(first, second):
    for topic, messages in first.items():
        different = [index for index, pair in enumerate(zip(messages, second[topic]))
                     if bytes_of(pair[0]) != bytes_of(pair[1])]
        assert not different, (f'{topic}: message {different[0]} is the first that differs:\n'
                               f'{messages[different[0]]}\n\n{second[topic][different[0]]}')


def compile_client(path):
    if not path.exists():
        flags = subprocess.run(['pkg-config', '--cflags', '--libs', 'roscpp'], check=True, text=True,
                               stdout=subprocess.PIPE).stdout.split()
        subprocess.run(['g++', '-o', path, CLIENTS_FOLDER / 'client.cpp', *flags], check=True)
    return path
