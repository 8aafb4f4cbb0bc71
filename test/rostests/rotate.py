#!/usr/bin/env python3
"""The turning node's side of the contract, over real topics."""

import math
import time
import unittest

import rospy
from geometry_msgs.msg import Quaternion, Twist, Vector3
from nav_msgs.msg import Odometry
from odometry_tests.messages import odometry
from odometry_tests.partners import NodeLog, Partner, SteppedClock
from odometry_tests.rostests import run_rostest
from odometry_tests.tutorial import rotator
from odometry_tests.waiting import Recorder, wait_for_subscribers, wait_until
from std_msgs.msg import Float64

NODES = 3
PERIOD = 0.1  # s, of the control
START = 1000.0  # s
NO_ROTATIONS = [Quaternion(), Quaternion(x=math.nan, w=1.0), Quaternion(z=math.inf, w=1.0)]


def turn(speed):
    """Return a Twist that is zero but for its turn to the left (rad/s)."""
    return Twist(angular=Vector3(z=speed))


class Talk(Partner):
    """Headings to a turning node, commands from it."""

    def __init__(self, namespace='', start=START):
        """Take a namespace that ends in a slash, or none, and the time (s) before the first."""
        super().__init__(f'/{namespace}odom', Odometry, f'/{namespace}cmd_vel', Twist)
        self._target = rospy.Publisher(f'/{namespace}rotate_robot/target', Float64, queue_size=10)
        self._time = start

    def heading(self, degrees, after=PERIOD):
        """Return the next odometry message, measured `after` seconds after the last."""
        self._time += after
        return odometry(yaw=math.radians(degrees), stamp=self._time)

    def face(self, degrees, speed):
        """Look there until the node commands this turn (rad/s)."""
        self.say_until(lambda: self.heading(degrees), lambda m: turns_at(m, speed),
                       f'a turn at {speed} rad/s at a heading of {degrees} degrees')

    def look(self, degrees, speed):
        """Look there once; return once the node has commanded this turn (rad/s)."""
        self.say(self.heading(degrees))
        self.answers.wait_for(lambda m: turns_at(m, speed),
                              what=f'a turn at {speed} rad/s at a heading of {degrees} degrees')

    def aim(self, degrees):
        """Send a new target."""
        wait_for_subscribers(self._target)
        self._target.publish(Float64(degrees))

    def begin(self):
        """Return with a node that turns to 90 degrees, its commands so far heard and forgotten."""
        self.aim(90.0)
        self.face(45.0, math.pi / 8)
        self.look(0.0, math.pi / 4)
        self.answers.clear()


def turns_at(command, speed):
    """Return whether a command is a turn on the spot at this speed (rad/s)."""
    return command == turn(command.angular.z) and abs(command.angular.z - speed) < 1e-9


class RotateTest(unittest.TestCase):
    """Given headings, the node turns the robot to its target."""

    @classmethod
    def setUpClass(cls):
        """Be the clock, hear the log, and talk to the node whose parameters are the defaults."""
        cls.log = NodeLog()
        cls.idle = Talk('idle/')
        cls.idle_commands = Recorder('/idle/cmd_vel', Twist)
        cls.clock = SteppedClock(NODES)
        cls.talk = Talk()

    def setUp(self):
        """Start it off."""
        self.talk.begin()

    def test_the_turn_is_the_gain_times_the_error_by_the_shorter_way(self):
        """With the error in (-pi, pi]: just 180 degrees off it turns to the left."""
        for target, heading, error in [
                (90, 0, 90), (90, 60, 30), (90, 135, -45), (-90, 0, -90), (-90, 91, 179),
                (180, 0, 180), (-180, 0, 180), (270, 0, -90), (360, 10, -10), (720, -10, 10),
                (-3690, 0, -90), (170, -170, -20), (-170, 170, 20), (0, 0, 0)]:
            self.talk.aim(target)
            self.talk.face(heading, 0.5 * math.radians(error))

    def test_commands_come_at_ten_hertz(self):
        """From odometry at 20 Hz: one command for two messages."""
        headings = [self.talk.heading(0.1 * count, after=0.05) for count in range(200)]
        self.talk.say(*headings, self.talk.heading(90.0))
        self.talk.answers.wait_for(lambda m: turns_at(m, 0.0), what='the last command')
        expected = [0.5 * math.radians(90 - 0.1 * count) for count in range(1, 200, 2)] + [0.0]
        commands = [message.angular.z for message in self.talk.answers.messages]
        self.assertEqual(len(commands), len(expected))
        self.assertTrue(all(map(math.isclose, commands, expected)), commands)

    def test_commands_go_on_while_odometry_is_late(self):
        """At the same rate, until the timeout stops the robot; then on when it returns."""
        # All stamps so far are ahead of the clock. Without one, the clock is what counts.
        self.talk.say(odometry(yaw=0.0))
        self.talk.answers.wait_for_count(1)
        self.talk.answers.clear()
        time.sleep(0.25)  # s; it takes no less for silence, however fast its time runs
        self.clock.advance(0.2)
        for count in range(1, 8):
            self.clock.advance(0.1)
            self.talk.answers.wait_for_count(count)
        commands = self.talk.answers.messages
        self.assertTrue(all(turns_at(m, math.pi / 4) for m in commands), commands)
        # The node may make up for the two periods in which it still waited.
        self.assertLessEqual(len(commands), 9)
        self.talk.answers.clear()
        self.clock.advance(0.1, 0.1)
        self.talk.answers.wait_for(lambda m: m == Twist(), what='a stop')
        self.log.wait_for_warning('/rotate_robot', 'no odometry arrives')
        self.talk.face(60.0, math.pi / 12)

    def test_parameters_change_how_it_turns(self):
        """In a namespace: target, gain, clamp, rate; the node outside hears nothing of it."""
        quick = Talk('quick/')
        quick.face(-45.0, 0.0)
        quick.face(-50.0, 2.0 * math.radians(5))
        quick.face(0.0, -0.3)
        quick.face(170.0, 0.3)
        quick.ask(*(quick.heading(-45.0, after=0.05) for _ in range(100)))
        self.assertEqual(self.talk.answers.messages, [])

    def test_the_turn_is_clamped_by_default_too(self):
        """No error reaches 3.14 rad/s with the gain of 0.5; a parameter does."""
        with rotator('_kp:=10', env={'ROS_NAMESPACE': 'eager'}):
            eager = Talk('eager/')
            eager.face(-80.0, 3.14)
            eager.face(-100.0, -3.14)

    def test_without_a_timeout_silence_does_not_stop_it(self):
        """It commands the same turn for as long as it hears nothing."""
        quick = Talk('quick/')
        quick.face(-50.0, 2.0 * math.radians(5))
        quick.answers.clear()
        for count in range(1, 9):
            self.clock.advance(0.5)
            commands = quick.answers.wait_for_count(count)
        self.assertTrue(all(turns_at(m, 2.0 * math.radians(5)) for m in commands), commands)

    def test_a_quaternion_that_is_no_rotation_is_ignored_and_warned_of(self):
        """No command answers it."""
        messages = [self.talk.heading(0.0) for _ in NO_ROTATIONS]
        for message, quaternion in zip(messages, NO_ROTATIONS):
            message.pose.pose.orientation = quaternion
        self.talk.say(*messages, self.talk.heading(60.0))
        self.assertTrue(turns_at(self.talk.answers.wait_for(), math.pi / 12))
        self.log.wait_for_warning('/rotate_robot', 'is no rotation')

    def test_a_target_that_is_no_number_is_refused(self):
        """With a warning, and the robot goes on turning to the target before."""
        for value in (math.nan, math.inf):
            self.talk.aim(value)
        self.log.wait_for_warning('/rotate_robot', 'target ignored: nan degrees is not finite')
        self.talk.face(60.0, math.pi / 12)

    def test_no_command_comes_before_the_first_odometry(self):
        """However long it takes."""
        self.clock.advance(*[0.1] * 30)
        self.idle.face(60.0, math.pi / 12)
        first = self.idle_commands.wait_for()
        self.assertTrue(turns_at(first, math.pi / 12), first)

    def test_within_the_tolerance_it_ends_once_the_robot_stands(self):
        """With exit status 0 and a zero; not outside, and not while it still turns."""
        # Time passes with the stamps while they are ahead of the clock, which may be heard late.
        talk = Talk('done/', self.clock.now.to_sec())
        with rotator('_tolerance:=1', env={'ROS_NAMESPACE': 'done'}) as node:
            talk.face(88.9, 0.5 * math.radians(1.1))
            # Behind this answer no earlier one is still on its way.
            talk.look(88.8, 0.5 * math.radians(1.2))
            standing = [88.9 + 0.005 * count for count in range(10)]
            for degrees in standing + [89.1 + 0.15 * count for count in range(12)]:
                talk.look(degrees, 0.5 * math.radians(90 - degrees))
            wait_until(lambda: self.stand(talk) or not node.running, 10.0,
                       lambda: f'its end; it printed:\n{node.output[-500:]}')
            self.assertEqual(node.wait(), 0, node.output)
        wait_until(lambda: talk.answers.last == Twist(), 5.0, 'a zero at last')
        self.assertRegex(node.stdout, r'^target=90\.0 current:1\.55\d+\n')

    def stand(self, talk):
        """Let the robot be seen at one heading for a while."""
        self.clock.advance(PERIOD)
        talk.say(talk.heading(90.5))


if __name__ == '__main__':
    run_rostest('rotate', RotateTest, disable_rostime=True)
