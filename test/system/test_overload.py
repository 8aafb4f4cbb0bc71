"""More than the machine can do: the node says so in one line, and what that means."""

import re
import resource

from nav_msgs.msg import Odometry
from odometry_tests.tutorial import simulator
from odometry_tests.waiting import Recorder
from std_msgs.msg import String

LIMIT = 64
ROBOTS = 12  # need more than that


def test_a_pace_that_no_machine_can_keep_is_told_of_once(simulated_time):
    with simulator('_odom_rate:=1000', '_real_time_factor:=1000',
                   env={'ROS_NAMESPACE': 'fast'}) as robot:
        robot.wait_for_output('too slow')
        warning = Recorder('/fast/sim_turtlebot/warning', String).wait_for(lambda m: m.data)
        assert robot.end() == 0, robot.output
    line, = robot.stderr.splitlines()
    assert warning.data in line
    reached = re.search(r'reaches a real-time factor of (\S+) instead of 1000$', line)[1]
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
