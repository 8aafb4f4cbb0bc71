"""What main.py prints; the test is the clock."""

from functools import partial

import pytest
import rospy
from geometry_msgs.msg import Quaternion
from nav_msgs.msg import Odometry
from odometry_tests.messages import odometry, strange_odometry
from odometry_tests.processes import rosrun
from odometry_tests.waiting import wait_for_subscribers, wait_until

START = partial(rosrun, 'rotate_robot', 'main.py')


@pytest.fixture
def show(ns, node, clock):
    publisher = rospy.Publisher(f'{ns}odom', Odometry, queue_size=1000)
    wait_for_subscribers(publisher)
    return lambda *messages: [publisher.publish(message) for message in messages]


def yaws(node):
    """Return the yaws printed (rad)."""
    return [float(line) for line in node.stdout.splitlines() if line[0] != '[']


def quaternions(node):
    """Return the quaternions printed, each a list of x, y, z, w."""
    return [list(map(float, line.strip('[]').split()))
            for line in node.stdout.splitlines() if line[0] == '[']


def test_it_prints_the_quaternion_once_a_second(node, show, clock):
    """That of the last message, whose length is one again."""
    begin, message = clock.now, odometry()
    message.pose.pose.orientation = Quaternion(z=3.0, w=4.0)
    show(message)
    wait_until(lambda: clock.advance(0.5) or quaternions(node), 10.0, 'a quaternion')
    before = len(quaternions(node))
    for count in range(1, 6):
        clock.advance(*[0.1] * 10)
        wait_until(lambda count=count: len(quaternions(node)) >= before + count, 10.0,
                   lambda: f'one more quaternion; it printed:\n{node.output[-1000:]}')
    # One is due at the beginning, and one may have been on its way then.
    assert len(quaternions(node)) <= (clock.now - begin).to_sec() + 2
    assert len(yaws(node)) == 1, 'one for each message'
    for numbers in quaternions(node):
        assert numbers == pytest.approx([0.0, 0.0, 0.6, 0.8], abs=1e-6)


def test_strange_odometry_does_not_end_it(node, show):
    """A quaternion that is no rotation is ignored with a warning; the next good one is printed."""
    show(*strange_odometry(), odometry(yaw=0.26))
    wait_until(lambda: yaws(node)[-1:] == pytest.approx([0.26]), 10.0, 'the last yaw')
    node.wait_for_output('is no rotation')
    assert node.end() == 0, node.output
