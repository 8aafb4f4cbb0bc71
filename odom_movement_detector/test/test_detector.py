"""The detector over real topics: odometry in, moved distance out."""

import pytest
import rospy
from nav_msgs.msg import Odometry
from odometry_tests.messages import odometry, strange_odometry
from odometry_tests.partners import Partner
from odometry_tests.tutorial import detector
from odometry_tests.waiting import Recorder, wait_until
from rosgraph_msgs.msg import Log
from std_msgs.msg import Float64

FIRST = 0.12  # m, counted before a test begins
PERIOD = 0.05  # s


@pytest.fixture
def node(request, ns):
    with detector(*getattr(request, 'param', [])) as process:
        yield process


@pytest.fixture
def partner(node, ns):
    """Return a Partner that tells positions to a detector that has begun, and records its distances."""
    partner = Partner(f'{ns}odom', Odometry, f'{ns}moved_distance', Float64)
    partner.say_until(odometry, lambda m: m.data == 0.0, 'a distance')
    return partner


@pytest.fixture
def walk(partner):
    """Return a function that goes to places (x in m), each higher, and returns the distances (m)."""
    partner.say(odometry(x=FIRST, stamp=1.0))
    partner.answers.wait_for(lambda m: m.data == FIRST, what=f'{FIRST} m')

    def walk(*places):
        messages = [odometry(x=x, stamp=1.0 + PERIOD * number) for number, x in enumerate(places, 1)]
        for number, message in enumerate(messages):
            message.pose.pose.position.z = number
        return [answer.data for answer in partner.ask(*messages)]

    return walk


def test_a_burst_is_counted_once_per_message_and_in_the_plane(partner, walk):
    distances = walk(*(FIRST + 0.02 * number for number in range(1, 2001)))
    assert (distances[0], distances[-1]) == pytest.approx((FIRST + 0.02, FIRST + 40.0))
    assert len(partner.answers.messages) == 2000


@pytest.mark.parametrize('node', [['_min_step:=0.1', '_max_speed:=0']], indirect=True)
def test_parameters_change_what_counts(walk):
    """With ~min_step slow motion adds up; with ~max_speed 0 a teleport counts."""
    assert walk(0.16, 0.2, 0.24, 5.24) == pytest.approx([0.12, 0.12, 0.24, 5.24])


def test_strange_odometry_is_ignored_with_a_warning(partner, node):
    partner.say(*strange_odometry())
    partner.say(*(odometry(x=0.01 * step, stamp=10000 + PERIOD * step) for step in range(20)))
    partner.answers.wait_for(lambda m: m.data > 0.189, what='the healthy messages\' distance')
    assert node.end() == 0, node.output
    assert 'is not finite' in node.output
    assert partner.answers.last.data < 0.191


def test_it_says_each_second_that_it_waits(ns):
    log = Recorder('/rosout', Log)

    def complaints():
        return [m for m in log.messages if f'waiting for odometry on {ns}odom' in m.msg]

    with detector():
        wait_until(lambda: len(complaints()) >= 2, 10.0, 'two complaints')
    assert complaints()[0].name.startswith(f'{ns}movement_detector_node_')


def test_a_topic_of_another_type_is_named_while_it_waits(ns):
    """The master knows it; the two are never connected."""
    publisher = rospy.Publisher(f'{ns}odom', Float64, queue_size=1)
    with detector() as node:
        node.wait_for_output(
            f'waiting for odometry: {ns}odom has the type std_msgs/Float64, not nav_msgs/Odometry')
    publisher.unregister()
