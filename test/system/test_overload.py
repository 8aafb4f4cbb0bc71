"""More than the machine can do: the node says so in one line, and what that means."""

import contextlib
import re
import resource
import socket
from urllib.parse import urlsplit

import rosgraph
import rospy
from nav_msgs.msg import Odometry
from odometry_tests.tutorial import mover, simulator
from odometry_tests.waiting import Recorder, wait_for_subscribers
from std_msgs.msg import Float64, String

LIMIT = 64
ROBOTS = 12  # need more than that


def test_a_pace_that_no_machine_can_keep_is_told_of_once(simulated_time):
    """In the log, and on a topic for the page, also if it comes later."""
    with simulator('_odom_rate:=1000', '_real_time_factor:=1000',
                   env={'ROS_NAMESPACE': 'fast'}) as robot:
        robot.wait_for_output('too slow')
        warning = Recorder('/fast/sim_turtlebot/warning', String).wait_for(lambda m: m.data)
        assert robot.end() == 0, robot.output
    line, = robot.stderr.splitlines()
    assert warning.data in line
    reached = re.search(r'reaches a real-time factor of (\S+) instead of 1000;', line)[1]
    assert 0 < float(reached) < 900


def with_limit(most):
    """Return options of a process that may open so many files, unless it asks for more.

    :param most: how many more it may ask for
    """
    return {'preexec_fn': lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (LIMIT, most))}


def test_a_node_takes_more_file_descriptors_than_usual_if_it_may(master):
    """Of many robots each topic takes one, and 1024 are usual."""
    with simulator(f'_robots:={ROBOTS}', env={'ROS_NAMESPACE': 'many'}, **with_limit(1024)):
        Recorder(f'/many/robot_{ROBOTS}/odom', Odometry).wait_for()


def test_a_node_that_starts_with_too_few_file_descriptors_says_so(master):
    with simulator(f'_robots:={ROBOTS}', env={'ROS_NAMESPACE': 'few'},
                   **with_limit(LIMIT)) as node:
        assert_out_of_file_descriptors(node, 'sim_turtlebot')


def test_a_node_that_runs_out_of_file_descriptors_says_so(master):
    """Nobody would reach it any more, and one of its threads would try again and again for ever."""
    distances = rospy.Publisher('moved_distance', Float64, queue_size=1)
    with mover('__name:=crowded', **with_limit(LIMIT)) as node, contextlib.ExitStack() as crowd:
        wait_for_subscribers(distances)
        address = urlsplit(rosgraph.Master('/test').lookupNode('/crowded'))
        for _ in range(LIMIT):
            with contextlib.suppress(OSError):
                crowd.enter_context(socket.create_connection((address.hostname, address.port)))
        assert_out_of_file_descriptors(node, 'test_movement')


def assert_out_of_file_descriptors(node, name):
    assert node.wait() == 1, node.output
    assert node.stderr == (f'{name}: out of file descriptors (limit {LIMIT}): raise it with '
                           'ulimit -n, or start fewer nodes')
