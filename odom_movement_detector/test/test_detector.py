"""The detector over real topics: odometry in, moved distance out."""

import math

import pytest
import rospy
from nav_msgs.msg import Odometry
from odometry_tests.messages import odometry, strange_odometry
from odometry_tests.partners import Partner
from odometry_tests.tutorial import detector
from odometry_tests.waiting import Recorder, wait_until
from rosgraph_msgs.msg import Log
from std_msgs.msg import Float64

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

    def walk(self, *places):
        """Go to places (x in m) one after the other, each higher; return the distances (m)."""
        messages = [odometry(x=x, stamp=1.0 + PERIOD * number) for number, x in enumerate(places, 1)]
        for number, message in enumerate(messages):
            message.pose.pose.position.z = number
        return [answer.data for answer in self.ask(*messages)]


@pytest.fixture
def node(request, ns):
    with detector(*getattr(request, 'param', [])) as process:
        yield process


@pytest.fixture
def talk(node, ns):
    made = Talk(ns)
    made.meet()
    return made


def test_a_burst_is_counted_once_per_message_and_in_the_plane(talk):
    distances = talk.walk(*(0.02 * number for number in range(1, 2001)))
    assert distances[0] == 0.02 and distances[-1] == pytest.approx(40.0)
    assert len(talk.answers.messages) == 2000


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
