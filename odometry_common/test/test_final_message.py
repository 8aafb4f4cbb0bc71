"""The last command of a node, after any sequence of commands and at any moment of its end.

rospy itself runs, but for its master; what it writes to a subscriber is read from the wire.
"""

import math
import threading

import rospy
from geometry_msgs.msg import Twist
from hypothesis import settings
from hypothesis.stateful import RuleBasedStateMachine, invariant, precondition, rule
from odometry_common.publishing import advertise
from odometry_common.velocity import VelocityPublisher
from odometry_tests.fuzzing import any_number, sequence_count
from rospy.impl.transport import OUTBOUND, Transport

TOPIC = '/cmd_vel'
HEADER_SIZE = 4  # bytes before each message, its length
END_TIMEOUT = 60.0  # s, for a thread that nothing holds up
ZERO = (0.0, 0.0)
STEPS = 12  # in a sequence; what matters is near the end of the node

speeds = any_number.filter(math.isfinite)


class Wire(Transport):
    """The connection to a subscriber: what has been written."""

    def __init__(self):
        """Begin with nothing written."""
        super().__init__(OUTBOUND)
        self.commands = []

    def write_data(self, data):
        """Take a message."""
        command = Twist().deserialize(data[HEADER_SIZE:])
        self.commands.append((command.linear.x, command.angular.z))

    def close(self):
        """Leave the publisher, which calls this again."""
        if not self.done:
            super().close()


class WatchedLock(threading.Semaphore):
    """A lock (of which Python lets no class be derived) that tells when a thread waits for it."""

    def __init__(self):
        """Begin unlocked."""
        super().__init__()
        self.awaited = threading.Event()

    def acquire(self, timeout=END_TIMEOUT):
        """Lock, however long the holder takes.

        What the node grants a subscriber that has stopped reading would here be granted the
        machine.
        """
        if super().acquire(blocking=False):
            return True
        self.awaited.set()
        return super().acquire(timeout=END_TIMEOUT)

    __enter__ = acquire


class Gate:
    """What a command passes on its way to rospy; something else may overtake it there."""

    def __init__(self, publisher):
        """Stand before a publisher."""
        self._publisher = publisher
        self.impl = publisher.impl
        self.meanwhile = None

    def publish(self, command):
        """Have the other thing happen first, if there is one."""
        if self.meanwhile is not None:
            meanwhile, self.meanwhile = self.meanwhile, None
            meanwhile()
        self._publisher.publish(command)


class EndingMachine(RuleBasedStateMachine):
    """A node that commands, stops and ends."""

    def __init__(self):
        """Connect a subscriber to a publisher of velocities."""
        super().__init__()
        rospy.core.set_initialized(True)
        self.topic = advertise(TOPIC, Twist)
        self.wire = Wire()
        self.topic.impl.add_connection(self.wire)
        self.velocity = VelocityPublisher(TOPIC)
        publisher = self.velocity._publisher
        self.lock = publisher._lock = WatchedLock()
        self.gate = publisher._publisher = Gate(publisher._publisher)
        # What rospy calls at shutdown, which a process can do only once.
        self.end_of_node = rospy.core._client_shutdown_hooks.pop()
        self.ended = False
        self.expected = []

    def teardown(self):
        """Disconnect."""
        self.wire.close()
        rospy.core.set_initialized(False)

    @rule(linear=speeds, angular=speeds)
    def command(self, linear, angular):
        """Command a velocity; after the end it goes nowhere."""
        self.velocity.publish(linear, angular)
        self.expect(linear, angular)

    @rule()
    def stop(self):
        """Command zero."""
        self.velocity.stop()
        self.expect(*ZERO)

    @precondition(lambda self: not self.ended)
    @rule()
    def end(self):
        """End the node."""
        self.end_of_node()
        self.expect(*ZERO)
        self.ended = True

    @precondition(lambda self: not self.ended)
    @rule(linear=speeds, angular=speeds)
    def end_during_a_command(self, linear, angular):
        """End the node while a command is being written."""
        self.during(self.end_of_node, lambda: self.velocity.publish(linear, angular))
        self.expect(linear, angular)
        self.expect(*ZERO)
        self.ended = True

    @precondition(lambda self: not self.ended)
    @rule(linear=speeds, angular=speeds)
    def command_during_the_end(self, linear, angular):
        """Command from another thread while the final zero is being written."""
        self.during(lambda: self.velocity.publish(linear, angular), self.end_of_node)
        self.expect(*ZERO)
        self.ended = True

    @invariant()
    def every_command_has_arrived_in_order(self):
        """And nothing after the zero of the end."""
        assert self.wire.commands == self.expected
        assert not self.ended or self.expected[-1] == ZERO

    def expect(self, linear, angular):
        """Note that this command should have arrived, unless the node has ended before."""
        if not self.ended:
            self.expected.append((linear, angular))

    def during(self, event, action):
        """Act, and have the event happen on another thread before the action's command is out.

        It happens to its end, or until it waits for the action.
        """
        stuck_or_done = self.lock.awaited
        stuck_or_done.clear()

        def happen():
            event()
            stuck_or_done.set()

        def meanwhile():
            thread.start()
            assert stuck_or_done.wait(END_TIMEOUT), 'the other thread is stuck'

        thread = threading.Thread(target=happen)
        self.gate.meanwhile = meanwhile
        action()
        thread.join(END_TIMEOUT)


TestEnding = EndingMachine.TestCase
TestEnding.settings = settings(
    TestEnding.settings, max_examples=sequence_count(), stateful_step_count=STEPS)
