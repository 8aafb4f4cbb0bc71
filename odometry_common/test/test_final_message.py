"""The last command of a node, at any moment of its end."""

import threading

import pytest
import rospy
from geometry_msgs.msg import Twist, Vector3
from odometry_common.velocity import VelocityPublisher
from odometry_tests.waiting import PATIENCE, TIMEOUT

OVERTAKING_TIME = 0.5  # s, in which a thread that waits for no lock overtakes another one
COMMAND, ZERO = Twist(linear=Vector3(x=0.1)), Twist()


class Overtaken:
    """Stands for a rospy.Publisher: before its first message it lets a second thread go on."""

    def __init__(self, publisher, other):
        self.impl, self.sent = publisher.impl, []
        self.other = threading.Thread(target=other)

    def publish(self, message):
        if not self.other.ident:
            self.other.start()
            self.other.join(OVERTAKING_TIME)
        self.sent.append(message)


@pytest.mark.parametrize('first, sent', [('command', [COMMAND, ZERO]), ('end', [ZERO])])
def test_zero_is_last_whichever_of_two_threads_overtakes_the_other(master, first, sent):
    """It follows a command that is being sent, and no command follows it."""
    velocity = VelocityPublisher('/final/cmd_vel')
    # What rospy calls at shutdown, which a process can do only once.
    actions = [lambda: velocity.publish(0.1), rospy.core._client_shutdown_hooks.pop()]
    begin, other = actions if first == 'command' else reversed(actions)
    velocity._publisher = publisher = Overtaken(velocity._publisher, other)
    begin()
    publisher.other.join(TIMEOUT * PATIENCE)
    assert publisher.sent == sent
