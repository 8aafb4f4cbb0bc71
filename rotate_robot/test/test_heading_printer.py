"""What main.py prints; the test is the clock."""

from functools import partial

import pytest
import rospy
from geometry_msgs.msg import Quaternion
from nav_msgs.msg import Odometry
from odometry_tests.messages import odometry, strange_odometry
from odometry_tests.processes import rosrun
from odometry_tests.waiting import wait_for_subscribers, wait_until
from tf.transformations import quaternion_from_euler

START = partial(rosrun, 'rotate_robot', 'main.py')


class Printer:
    """main.py, what it is shown, and what it prints."""

    def __init__(self, ns, process, clock):
        self._odometry = rospy.Publisher(f'{ns}odom', Odometry, queue_size=1000)
        self.process, self.clock = process, clock
        wait_for_subscribers(self._odometry)

    def show(self, *messages):
        for message in messages:
            self._odometry.publish(message)

    def turn(self, quaternion):
        message = odometry()
        message.pose.pose.orientation = quaternion
        self.show(message)

    def wait_for(self, lines, count):
        """Return once there are so many of yaws or quaternions."""
        wait_until(lambda: len(lines()) >= count, 10.0,
                   lambda: f'{count} lines; it printed:\n{self.process.output[-1000:]}')

    def yaws(self):
        """Return the yaws printed (rad)."""
        return [float(line) for line in self.process.stdout.splitlines() if line[0] != '[']

    def quaternions(self):
        """Return the quaternions printed, each a list of x, y, z, w."""
        return [list(map(float, line.strip('[]').split()))
                for line in self.process.stdout.splitlines() if line[0] == '[']


@pytest.fixture
def printer(ns, node, clock):
    return Printer(ns, node, clock)


def test_it_prints_each_yaw_in_radians(printer):
    """One line for each message, from a robot that may lean, and nothing else."""
    angles = [(0.1, -0.2, 0.01 * step - 3.0) for step in range(600)]
    for one in angles:
        printer.turn(Quaternion(*quaternion_from_euler(*one)))
    printer.wait_for(printer.yaws, len(angles))
    assert printer.yaws() == pytest.approx([yaw for _, _, yaw in angles])


def test_it_prints_the_quaternion_once_a_second(printer):
    """That of the last message, whose length is one again."""
    begin = printer.clock.now
    printer.turn(Quaternion(z=3.0, w=4.0))
    printer.wait_for(printer.yaws, 1)
    wait_until(lambda: printer.clock.advance(0.5) or printer.quaternions(), 10.0, 'a quaternion')
    before = len(printer.quaternions())
    for count in range(1, 6):
        printer.clock.advance(*[0.1] * 10)
        printer.wait_for(printer.quaternions, before + count)
    # One is due at the beginning, and one may have been on its way then.
    assert len(printer.quaternions()) <= (printer.clock.now - begin).to_sec() + 2
    for numbers in printer.quaternions():
        assert numbers == pytest.approx([0.0, 0.0, 0.6, 0.8], abs=1e-6)


def test_strange_odometry_does_not_end_it(printer):
    """A quaternion that is no rotation is ignored with a warning; the next good one is printed."""
    printer.show(*strange_odometry(), odometry(yaw=0.26))
    wait_until(lambda: printer.yaws()[-1:] == pytest.approx([0.26]), 10.0, 'the last yaw')
    printer.process.wait_for_output('is no rotation')
    assert printer.process.end() == 0, printer.process.output
