"""The last command of a node, at any moment of its end."""

import threading

import pytest
import rospy
from geometry_msgs.msg import Twist
from odometry_common.publishing import advertise
from odometry_common.velocity import VelocityPublisher
from odometry_tests.waiting import PATIENCE, TIMEOUT
from rospy.impl.transport import OUTBOUND, Transport

TOPIC = '/final/cmd_vel'
HEADER_SIZE = 4  # bytes before each message, its length
ZERO = (0.0, 0.0)


class WatchedLock:
    """A lock that tells when a thread waits for it."""

    def __init__(self, awaited):
        self._lock, self._awaited = threading.Lock(), awaited

    def __enter__(self):
        if not self._lock.acquire(blocking=False):
            self._awaited.set()
            self._lock.acquire()

    def __exit__(self, *_):
        self._lock.release()


class Wire(Transport):
    """A node that commands, and its connection to a subscriber: what has been written."""

    def __init__(self):
        super().__init__(OUTBOUND)
        self.commands, self._meanwhile = [], None
        advertise(TOPIC, Twist).impl.add_connection(self)
        velocity = VelocityPublisher(TOPIC)
        self._stuck_or_done = threading.Event()
        velocity._lock = WatchedLock(self._stuck_or_done)
        self.publish = velocity.publish
        # What rospy calls at shutdown, which a process can do only once.
        self.shut_down = rospy.core._client_shutdown_hooks.pop()

    def write_data(self, data):
        """Take a message, and let the other thread overtake it."""
        meanwhile, self._meanwhile = self._meanwhile, None
        if meanwhile:
            meanwhile.start()
            assert self._stuck_or_done.wait(TIMEOUT * PATIENCE)
        command = Twist().deserialize(data[HEADER_SIZE:])
        self.commands.append((command.linear.x, command.angular.z))

    def during(self, action, other):
        """Do something, and on a second thread another thing while the first is being written."""
        def do():
            other()
            self._stuck_or_done.set()

        self._meanwhile = thread = threading.Thread(target=do)
        action()
        thread.join(TIMEOUT * PATIENCE)


@pytest.fixture
def wire(master):
    made = Wire()
    yield made
    made.close()


def test_zero_follows_a_command_that_is_being_written(wire):
    wire.during(lambda: wire.publish(0.1), wire.shut_down)
    assert wire.commands == [(0.1, 0.0), ZERO]


def test_no_command_overtakes_the_final_zero_or_follows_it(wire):
    wire.during(wire.shut_down, lambda: wire.publish(0.1))
    assert wire.commands == [ZERO]
