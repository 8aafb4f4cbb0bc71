#!/usr/bin/env python3
"""The detector's side of the contract, over real topics."""

import math
import random
import unittest

import rospy
from nav_msgs.msg import Odometry
from odometry_tests.messages import odometry
from odometry_tests.partners import NodeLog, Partner, differences
from odometry_tests.rostests import run_rostest
from odometry_tests.tutorial import detector
from odometry_tests.waiting import wait_for_subscribers, wait_until
from std_msgs.msg import Empty, Float64

PERIOD = 0.02  # s between two odometry messages
START = 1000.0  # s, the time stamp of the first one
LONG_TIME = 10.0  # s; enough for any path, so that going back to zero is no teleport


class Talk(Partner):
    """Positions to a detector, distances from it."""

    def __init__(self, namespace=''):
        """Take a namespace that ends in a slash, or none."""
        super().__init__(f'/{namespace}odom', Odometry, f'/{namespace}moved_distance', Float64)
        self._reset = rospy.Publisher(f'/{namespace}moved_distance/reset', Empty, queue_size=1)
        self._time = START

    def position(self, x, y=0.0, z=0.0, stamp=None):
        """Return the next odometry message, measured at `stamp` (s) or a moment after the last."""
        self._time += PERIOD
        message = odometry(x, y, stamp=self._time if stamp is None else stamp)
        message.pose.pose.position.z = z
        return message

    def meet(self):
        """Return once the detector has heard and answered all that was said to it."""
        self.say_until(lambda: self.position(0.0), lambda _: True, 'a distance')
        self.say(self.position(0.06), self.position(0.12))
        self.answers.wait_for(lambda m: m.data > 0.1, what='two steps')

    def reset(self):
        """Have it count from zero again at x = 0."""
        wait_for_subscribers(self._reset)
        self._time += LONG_TIME
        # If it were at zero already, a reset that is still on its way could not be told from one
        # that has come.
        self.walk(0.0, 0.05, 0.0)
        self._reset.publish(Empty())
        wait_until(lambda: self.tell(self.position(0.0)) == [0.0], 3.0, 'a reset')

    def tell(self, *messages):
        """Send odometry messages and return the distances that answer them."""
        return [answer.data for answer in self.ask(*messages)]

    def walk(self, *places):
        """Go to places (x in m) one after the other and return the distances (m)."""
        return self.tell(*map(self.position, places))


class DetectorTest(unittest.TestCase):
    """Given odometry, the detector publishes the distance."""

    @classmethod
    def setUpClass(cls):
        """Hear the log, and talk to the detector whose parameters are the defaults."""
        cls.log = NodeLog()
        cls.talk = Talk()
        cls.talk.meet()

    def setUp(self):
        """Start it from zero."""
        self.talk.reset()

    def test_it_publishes_the_sum_of_the_steps_once_per_message(self):
        """On a long walk not one message is lost, and the sum is equal bit for bit."""
        numbers, total, expected, messages = random.Random(1), 0.0, [], []
        x = y = 0.0
        for _ in range(2000):
            new_x, new_y = x + numbers.uniform(-0.02, 0.02), y + numbers.uniform(-0.02, 0.02)
            total += math.hypot(new_x - x, new_y - y)
            expected.append(total)
            x, y = new_x, new_y
            messages.append(self.talk.position(x, y, z=numbers.random()))
        self.assertEqual(differences(self.talk.tell(*messages), expected)[:1], [])
        self.assertEqual(len(self.talk.answers.messages), 2000)

    def test_a_reset_counts_from_zero(self):
        """From the position of the last message on."""
        self.assertGreater(self.talk.walk(0.05, 0.0)[-1], 0.09)
        self.talk.reset()
        self.assertEqual(self.talk.walk(0.03), [0.03])

    def test_a_distance_below_a_micrometre_is_zero(self):
        """So that the tutorial's first lines are plain zeros."""
        self.assertEqual(self.talk.walk(5e-7, 5e-7, 2e-6), [0.0, 0.0, 2e-6])

    def test_a_teleport_is_not_counted_and_warned_of(self):
        """It is faster than 5 m/s; the step after it counts."""
        before, after, step = self.talk.walk(0.05, 3.0, 3.05)
        self.assertEqual(before, after)
        self.assertAlmostEqual(step, 0.10)
        wait_until(lambda: self.talk.walk(0.0, 3.0)
                   and self.log.has_warning('/detector', 'faster than ~max_speed'), 10.0, 'a warning')

    def test_five_metres_per_second_still_count(self):
        """0.1 m is the step of one period; a little more is a teleport."""
        self.assertEqual(self.talk.walk(0.099, 0.2), [0.099, 0.099])

    def test_a_stamp_that_goes_back_is_not_counted(self):
        """As after a simulator's reset or at the end of a looping bag."""
        distances = self.talk.tell(
            self.talk.position(0.05), self.talk.position(0.0, stamp=1.0),
            self.talk.position(0.03, stamp=1.02))
        self.assertEqual([round(distance, 12) for distance in distances], [0.05, 0.05, 0.08])

    def test_one_late_message_counts_nothing_but_is_answered(self):
        """It was overtaken, or comes a second time; the next step is counted from where it was."""
        first, second, third, fourth = map(self.talk.position, (0.02, 0.04, 0.06, 0.08))
        distances = self.talk.tell(first, third, second, fourth, second, self.talk.position(0.1))
        self.assertEqual([round(distance, 12) for distance in distances],
                         [0.02, 0.06, 0.06, 0.08, 0.08, 0.1])

    def test_bunched_stamps_lose_nothing(self):
        """Two and two messages share nearly the same one, at 3 m/s."""
        messages = [self.talk.position(0.06 * number) for number in range(1, 101)]
        for message in messages[1::2]:
            message.header.stamp -= rospy.Duration(0.0199)
        self.assertAlmostEqual(self.talk.tell(*messages)[-1], 6.0)

    def test_positions_that_are_no_numbers_are_ignored(self):
        """No distance is published for them, and they are warned of."""
        self.talk.say(self.talk.position(math.nan), self.talk.position(0.0, math.inf))
        self.assertEqual(self.talk.walk(0.05, 0.06), [0.05, 0.06])
        self.log.wait_for_warning('/detector', 'is not finite')

    def test_parameters_change_what_counts(self):
        """With ~min_step slow motion adds up; with ~max_speed 0 a teleport counts."""
        careful = Talk('careful/')
        careful.meet()
        careful.reset()
        distances = careful.walk(*(0.04 * step for step in range(1, 8)), 5.24)
        self.assertEqual([round(distance, 9) for distance in distances],
                         [0.0, 0.0, 0.12, 0.12, 0.12, 0.24, 0.24, 5.24])

    def test_it_says_each_second_that_it_waits(self):
        """On the log, until the first odometry; its own name is anonymous."""
        with detector(env={'ROS_NAMESPACE': 'waiting'}):
            wait_until(lambda: len(self.complaints()) >= 2, 10.0, 'two complaints')
            Talk('waiting/').meet()
        for message in self.complaints():
            self.assertRegex(message.name, '^/waiting/movement_detector_node_[0-9]+_[0-9]+$')

    def complaints(self):
        """Return what a detector in the namespace has logged about waiting."""
        return [message for message in self.log.messages
                if 'waiting for odometry on /waiting/odom' in message.msg]


if __name__ == '__main__':
    run_rostest('detector', DetectorTest)
