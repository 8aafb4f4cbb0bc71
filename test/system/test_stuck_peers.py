"""Subscribers that do not read, and other stuck peers, which affect no one else."""

import contextlib
import signal
import socket
import xmlrpc.client
from io import BytesIO
from urllib.parse import urlparse

import pytest
import rosgraph
from geometry_msgs.msg import Twist
from odometry_common.connections import ANSWER
from odometry_tests.partners import Partner
from odometry_tests.pausing import call
from odometry_tests.tutorial import Truth, mover, rotator, simulator, simulator_in_step
from odometry_tests.waiting import PATIENCE, TIMEOUT, wait_until
from rosgraph.network import read_ros_handshake_header, write_ros_handshake_header
from std_msgs.msg import Float64

COUNT = 2000  # messages
FULL_TIME = 60.0  # s, until a socket is full
NAME = '/stuck'
SMALL_SEGMENT = 536  # bytes; a publisher then sets aside little memory for what is not read yet
WARNING = '/stuck does not keep up with {}: it loses messages'


@contextlib.contextmanager
def stuck_subscriber(topic):
    wait_until(lambda: publisher_of(topic), TIMEOUT, f'a publisher of {topic}')
    with connected(publisher_of(topic), topic) as connection:
        write_ros_handshake_header(connection, {
            'callerid': NAME, 'topic': topic, 'type': '*', 'md5sum': '*', 'tcp_nodelay': '1'})
        header = read_ros_handshake_header(connection, BytesIO(), 1)
        assert 'error' not in header, header
        yield


@contextlib.contextmanager
def connected(node, topic):
    with xmlrpc.client.ServerProxy(rosgraph.Master(NAME).lookupNode(node)) as api:
        _, host, port = api.requestTopic(NAME, topic, [['TCPROS']])[ANSWER]
    with socket.socket() as connection:
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1)  # the system's smallest
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_MAXSEG, SMALL_SEGMENT)
        connection.settimeout(TIMEOUT * PATIENCE)
        connection.connect((host, port))
        yield connection


def publisher_of(topic):
    publishers = dict(rosgraph.Master(NAME).getSystemState()[0]).get(topic)
    return publishers and publishers[0]


def is_drive(command):
    return command != Twist()


def assert_ends_at_once(node):
    assert node.end() == 0, node.output


@pytest.mark.usefixtures('simulated_time')
@pytest.mark.parametrize('start', [
    simulator, pytest.param(simulator_in_step, marks=pytest.mark.nightly)], ids=['unpaced', 'in lockstep'])
def test_the_simulator_goes_on_for_others_and_ends(start):
    """With a subscriber to each topic that does not read; the others miss nothing."""
    truth = Truth()
    # In lockstep it would take long until a socket is full of such short messages as the clock's.
    topics = ['/odom', '/tf'] if start is simulator_in_step else ['/odom', '/tf', '/clock']
    with start('_real_time_factor:=0', '_paused:=true') as node, rotator('_kp:=0.01'), \
            contextlib.ExitStack() as stuck:
        for topic in topics:
            stuck.enter_context(stuck_subscriber(topic))
        truth.wait_for_publisher()
        call('unpause_physics')
        numbers = [message.header.seq for message in truth.wait_for_count(COUNT, FULL_TIME)]
        for topic in topics:
            node.wait_for_output(WARNING.format(topic), FULL_TIME)
        assert_ends_at_once(node)
    assert numbers == list(range(numbers[0], numbers[0] + COUNT))
    assert node.output.count('does not keep up') == len(topics)


def test_peers_that_say_nothing_keep_no_subscriber_out_and_no_node_alive(master):
    """One is connected to the port of the node's topics, one to that of its XML-RPC API."""
    with mover() as node:
        wait_until(lambda: publisher_of('/cmd_vel'), 20.0, 'the mover')
        api = urlparse(rosgraph.Master('/test').lookupNode(publisher_of('/cmd_vel')))
        with connected(publisher_of('/cmd_vel'), '/cmd_vel'), socket.create_connection((api.hostname, api.port)):
            Partner('moved_distance', Float64, 'cmd_vel', Twist).say_until(Float64, is_drive, 'a command')
            assert_ends_at_once(node)


def test_a_node_whose_master_is_stuck_goes_on_stops_the_robot_and_ends(master):
    """It cannot unregister: its names stay on the master, so this test has a namespace."""
    with mover(env={'ROS_NAMESPACE': '/forgotten'}) as node:
        talk = Partner('/forgotten/moved_distance', Float64, '/forgotten/cmd_vel', Twist)
        talk.say_until(Float64, is_drive, 'a command')
        master.send(signal.SIGSTOP)
        try:
            talk.say_until(Float64, is_drive, 'a command without a master')
            assert_ends_at_once(node)
        finally:
            master.send(signal.SIGCONT)
    wait_until(lambda: talk.answers.last == Twist(), 10.0, 'zero as the last command')
