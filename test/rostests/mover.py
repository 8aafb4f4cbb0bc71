#!/usr/bin/env python3
"""The mover's side of the contract, over real topics."""

import math
import random
import time
import unittest

from geometry_msgs.msg import Twist, Vector3
from nav_msgs.msg import Odometry
from odometry_tests.messages import STRANGE, odometry
from odometry_tests.partners import NodeLog, Partner, SteppedClock, differences
from odometry_tests.rostests import run_rostest
from odometry_tests.tutorial import detector, mover
from odometry_tests.waiting import wait_until
from rosgraph_msgs.msg import Log
from std_msgs.msg import Float64

NODES = 3
WALL_SILENCE = 0.25  # s; it does not take less for silence, however fast its time runs
FAR = 1e6  # m, beyond every goal
JUST_BEFORE_TWO = 2.0 - 2.0**-52  # m


def commands(*speeds):
    """Return Twists that are zero but for their speed ahead (m/s)."""
    return [Twist(linear=Vector3(x=speed)) for speed in speeds]


class Talk(Partner):
    """Distances to a mover, commands from it."""

    def __init__(self, namespace=''):
        """Take a namespace that ends in a slash, or none."""
        super().__init__(f'/{namespace}moved_distance', Float64, f'/{namespace}cmd_vel', Twist)

    def begin(self):
        """Return with a mover that drives, and with all its commands so far heard and forgotten."""
        self.say_until(lambda: Float64(FAR), lambda m: m.linear.x == 0, 'a stop')
        self.say(Float64(0.0))
        self.answers.wait_for(lambda m: m.linear.x != 0, what='a start')
        self.answers.clear()

    def tell(self, *distances):
        """Send distances (m) and return the commands that answer them."""
        return self.ask(*map(Float64, distances))


class MoverTest(unittest.TestCase):
    """Given moved distances, the mover commands the robot."""

    @classmethod
    def setUpClass(cls):
        """Be the clock, hear the log, and talk to the mover whose parameters are the defaults."""
        cls.log = NodeLog()
        cls.clock = SteppedClock(NODES)
        cls.talk = Talk()

    def setUp(self):
        """Start it off."""
        self.begin()

    def begin(self):
        """Start it until it has read the clock: it says by its own time that it starts."""
        wait_until(lambda: self.talk.begin() or self.log.has_heard(
            '/test_movement', self.clock.now), 10.0, 'a mover that knows the time')

    def test_each_distance_alone_decides_on_one_command(self):
        """A thousand distances in any order: as many commands, and not one more."""
        numbers = random.Random(1)
        distances = [numbers.uniform(0.0, 4.0) for _ in range(1000)]
        expected = commands(*(0.1 if distance < 2.0 else 0.0 for distance in distances))
        self.assertEqual(differences(self.talk.tell(*distances), expected)[:1], [])
        # A reset of the distance sends the robot off again: it has no memory of having arrived.
        self.assertEqual(self.talk.tell(2.1, 0.0, 1.0, 2.0), commands(0.0, 0.1, 0.1, 0.0))

    def test_it_stops_at_two_metres_and_not_before(self):
        """To the bit."""
        distances = 0.0, 1.999999, JUST_BEFORE_TWO, 2.0, 2.5
        self.assertEqual(self.talk.tell(*distances), commands(0.1, 0.1, 0.1, 0.0, 0.0))

    def test_a_distance_that_is_no_number_stops_it_and_is_warned_of(self):
        """As one does that is beyond every goal; the next healthy distance decides anew."""
        self.assertEqual(self.talk.tell(*STRANGE), commands(0.0, 0.0, 0.0, 0.0, 0.1, 0.1, 0.1))
        self.assertEqual(self.talk.tell(math.inf, 1.0), commands(0.0, 0.1))
        self.log.wait_for_warning('/test_movement', 'the moved distance nan is not finite')

    def test_silence_stops_it_until_distances_return(self):
        """After one second; a standing robot is not stopped again."""
        self.be_silent_until_it_stops()
        self.assertEqual(self.talk.answers.messages, commands(0.0))
        self.log.wait_for_warning('/test_movement', 'no moved_distance arrives')
        self.clock.advance(*[0.1] * 30)
        self.talk.say(Float64(1.0))
        self.assertEqual(self.talk.answers.wait_for_count(2), commands(0.0, 0.1))

    def test_the_silence_that_stops_it_lasts_a_second(self):
        """Not 0.9 s, and no more than two of its ten looks a second longer."""
        self.talk.say(Float64(0.0))
        self.talk.answers.wait_for_count(1)
        time.sleep(WALL_SILENCE)
        self.clock.advance(*[0.1] * 9)
        self.talk.say(Float64(1.0))
        self.assertEqual(self.talk.answers.wait_for_count(2), commands(0.1, 0.1))
        time.sleep(WALL_SILENCE)
        self.clock.advance(*[0.1] * 13)
        self.assertEqual(self.talk.answers.wait_for_count(3), commands(0.1, 0.1, 0.0))

    def be_silent_until_it_stops(self):
        """Let time pass, simulated and real."""
        def stopped():
            self.clock.advance(0.1)
            return Twist() in self.talk.answers.messages
        wait_until(stopped, 10.0, 'a stop')

    def test_slow_distances_are_no_silence(self):
        """One in 0.9 s."""
        for _ in range(5):
            self.clock.advance(0.9)
            self.assertEqual(self.talk.tell(0.0, FAR), commands(0.1, 0.0))
            self.begin()
        self.assertEqual(self.talk.tell(0.0), commands(0.1))

    def test_it_drives_backwards_as_far_as_it_is_told(self):
        """In a namespace; the mover outside hears nothing of it."""
        back = Talk('back/')
        back.begin()
        self.assertEqual(back.tell(0.0, 0.499, 0.5, 3.0), commands(-0.2, -0.2, 0.0, 0.0))
        self.talk.say(Float64(FAR))
        self.talk.answers.wait_for(lambda m: m == Twist())
        self.assertEqual(self.talk.answers.messages, commands(0.0))

    def test_without_a_timeout_silence_does_not_stop_it(self):
        """The mover beside it, which has one, is stopped again and again meanwhile."""
        back = Talk('back/')
        back.begin()
        for _ in range(5):
            self.begin()
            self.be_silent_until_it_stops()
        back.say(Float64(0.1))
        self.assertEqual(back.answers.wait_for_count(1), commands(-0.2))

    def test_relative_counts_from_the_first_distance(self):
        """It would be beyond the goal for any other mover."""
        relative = Talk('relative/')
        relative.say_until(lambda: Float64(10.0), lambda m: m.linear.x == 0.1, 'a start')
        relative.say(Float64(FAR))
        relative.answers.wait_for(lambda m: m.linear.x == 0, what='a stop')
        self.assertEqual(relative.tell(11.999, 12.0, 0.0), commands(0.1, 0.0, 0.1))

    def test_exit_when_done_ends_it_once_the_robot_stands(self):
        """With exit status 0, and not while the distance still grows."""
        done = Talk('done/')
        with mover('_exit_when_done:=true', env={'ROS_NAMESPACE': 'done'}) as node:
            done.say_until(lambda: Float64(0.0), lambda m: m.linear.x == 0.1, 'a start')
            done.say(Float64(2.0))
            done.answers.wait_for(lambda m: m == Twist(), what='a stop')
            for distance in (2.01, 2.02, 2.03):
                self.clock.advance(0.4)
                self.assertEqual(done.tell(distance), commands(0.0))
            self.assertTrue(node.running)
            wait_until(lambda: self.rest(done) or not node.running, 10.0,
                       lambda: f'its end; it printed:\n{node.output}')
            self.assertEqual(node.wait(), 0, node.output)
        wait_until(lambda: done.answers.last == Twist(), 5.0, 'a zero at last')

    def test_two_publishers_of_the_distance_are_warned_of_once_by_name(self):
        """A detector that was left running sends the robot off whenever the other one stops it."""
        there = {'ROS_NAMESPACE': 'two'}
        talk = Talk('two/')
        left = Partner('/two/odom', Odometry, '/two/moved_distance', Float64)
        with mover(env=there):
            wait_until(lambda: talk.begin() or self.lines_of_two(), 10.0, 'its log')
            with detector(env=there):
                # It tells each change in a line of its own, the last ones after any warning.
                wait_until(lambda: talk.say(Float64(FAR)) or left.say(odometry())
                           or len(self.lines_of_two()) > 100, 20.0, 'many starts and stops')
        warnings = [line.msg for line in self.lines_of_two() if line.level == Log.WARN]
        self.assertEqual(len(warnings), 1, warnings)
        self.assertIn('/mover_test', warnings[0])
        self.assertIn('/two/movement_detector_node_', warnings[0])

    def lines_of_two(self):
        """Return what the mover in that namespace has logged."""
        return [line for line in self.log.messages if line.name == '/two/test_movement']

    def rest(self, talk):
        """Let the robot stand for a moment."""
        self.clock.advance(0.1)
        talk.say(Float64(2.03))


if __name__ == '__main__':
    run_rostest('mover', MoverTest, disable_rostime=True)
