"""The detector over real topics: odometry in, moved distance out."""

import math
import random

import pytest
import rospy
from nav_msgs.msg import Odometry
from odometry_tests.messages import odometry, strange_odometry
from odometry_tests.partners import Partner
from odometry_tests.tutorial import detector
from odometry_tests.waiting import Recorder, wait_for_subscribers, wait_until
from rosgraph_msgs.msg import Log
from std_msgs.msg import Empty, Float64

FIRST = 0.01  # m, counted before a test begins
PERIOD = 0.05  # s
TELEPORT = 3.0  # m


class Talk(Partner):
    """Positions to a detector, distances from it."""

    def __init__(self, ns):
        super().__init__(f'{ns}odom', Odometry, f'{ns}moved_distance', Float64)

    def meet(self):
        self.say_until(odometry, lambda m: m.data == 0.0, 'a distance')
        self.say(odometry(x=FIRST, stamp=1.0))
        self.answers.wait_for(lambda m: m.data == FIRST, what=f'{FIRST} m')

    def walk(self, *places, start=1.0, period=PERIOD):
        """Go to places (x in m) one after the other; return the distances (m)."""
        return [answer.data for answer in self.ask(*(
            odometry(x=x, stamp=start + period * number) for number, x in enumerate(places, 1)))]


@pytest.fixture
def node(request, ns):
    with detector(*getattr(request, 'param', [])) as process:
        yield process


@pytest.fixture
def talk(node, ns):
    made = Talk(ns)
    made.meet()
    return made


def test_it_publishes_the_sum_of_the_steps_once_per_message(talk):
    """On a long walk no message is lost, and the sum is equal bit for bit, whatever z is."""
    numbers, total, expected, messages = random.Random(1), FIRST, [], []
    x, y = FIRST, 0.0
    for number in range(2000):
        new_x, new_y = x + numbers.uniform(-0.02, 0.02), y + numbers.uniform(-0.02, 0.02)
        total += math.hypot(new_x - x, new_y - y)
        expected.append(total)
        x, y = new_x, new_y
        messages.append(odometry(x, y, stamp=2 + PERIOD * number))
        messages[-1].pose.pose.position.z = numbers.random()
    assert [m.data for m in talk.ask(*messages)] == expected
    assert len(talk.answers.messages) == 2000


def test_a_reset_counts_from_zero(talk, ns):
    reset = rospy.Publisher(f'{ns}moved_distance/reset', Empty, queue_size=1)
    wait_for_subscribers(reset)
    reset.publish(Empty())
    wait_until(lambda: talk.walk(FIRST) == [0.0], 10.0, 'a reset')
    assert talk.walk(0.04, start=2.0) == [0.04 - FIRST]


def test_a_jump_is_not_counted_and_warned_of(talk, node):
    assert talk.walk(TELEPORT, TELEPORT + 0.05) == pytest.approx([FIRST, FIRST + 0.05])
    node.wait_for_output('faster than ~max_speed')


@pytest.mark.parametrize('node', [['_min_step:=0.1', '_max_speed:=0']], indirect=True)
def test_parameters_change_what_counts(node, ns):
    """With ~min_step slow motion adds up; with ~max_speed 0 a teleport counts."""
    talk = Talk(ns)
    talk.say_until(odometry, lambda _: True, 'a distance')
    talk.say(odometry(x=0.12))
    talk.answers.wait_for(lambda m: m.data == 0.12, what='a step')
    assert talk.walk(0.16, 0.2, 0.24, 5.24) == pytest.approx([0.12, 0.12, 0.24, 5.24])


def test_strange_odometry_is_ignored_and_the_sum_stays_finite_and_never_falls(node, ns):
    talk = Talk(ns)
    talk.say_until(odometry, lambda m: m.data == 0.0, 'a distance')
    talk.say(*strange_odometry())
    talk.say(*(odometry(x=0.01 * step, stamp=10000 + 0.05 * step) for step in range(20)))
    talk.answers.wait_for(lambda m: m.data > 0.189, what='the healthy messages\' distance')
    assert node.end() == 0, node.output
    assert 'is not finite' in node.output
    distances = [message.data for message in talk.answers.messages]
    assert all(map(math.isfinite, distances)) and distances == sorted(distances)
    assert distances[-1] < 0.191


def test_it_says_each_second_that_it_waits(ns):
    log = Recorder('/rosout', Log)

    def complaints():
        return [m for m in log.messages if f'waiting for odometry on {ns}odom' in m.msg]

    with detector():
        wait_until(lambda: len(complaints()) >= 2, 10.0, 'two complaints')
        Talk(ns).meet()
    assert complaints()[0].name.startswith(f'{ns}movement_detector_node_')


def test_a_topic_of_another_type_is_named_while_it_waits(ns):
    """The master knows it; the two are never connected."""
    publisher = rospy.Publisher(f'{ns}odom', Float64, queue_size=1)
    with detector() as node:
        node.wait_for_output(
            f'waiting for odometry: {ns}odom has the type std_msgs/Float64, not nav_msgs/Odometry')
    publisher.unregister()
