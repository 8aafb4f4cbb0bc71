"""Messages that no healthy driver sends, and more of them than anybody expects."""

import itertools
import math
import threading

import pytest
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from odometry_tests.messages import odometry
from odometry_tests.processes import rosrun
from odometry_tests.tutorial import Truth, detector, mover, rotator, simulator, speed
from odometry_tests.waiting import Recorder, wait_for_subscribers, wait_until
from std_msgs.msg import Float64

STRANGE = [math.nan, math.inf, -math.inf, 1e308, -1e308, 5e-324, -0.0]
QUATERNIONS = [(0, 0, 0, 0), (0, 0, 0, 1e-320), (0, 0, 3, 4), (1e200, 0, 0, 1e200),
               *((value, 0, 0, 1) for value in STRANGE)]
STAMPS = [0.0, 5.0, 5.0, 4.0, 3605.0, 5.0]
QUEUE_SIZE = 1000
CASES = itertools.count(1)


@pytest.fixture
def ns(master, monkeypatch):
    """Give each test's nodes a namespace of their own: no connection is left from another one."""
    name = f'case_{next(CASES)}'
    monkeypatch.setenv('ROS_NAMESPACE', name)
    return f'/{name}/'


def strange_odometry():
    """Return an Odometry with each strange number in each place, and strange stamps and frames."""
    messages = [odometry(stamp=stamp) for stamp in STAMPS]
    messages += [odometry(x=value) for value in STRANGE] + [odometry(y=value) for value in STRANGE]
    for numbers in QUATERNIONS:
        message = odometry()
        turn = message.pose.pose.orientation
        turn.x, turn.y, turn.z, turn.w = numbers
        messages.append(message)
    messages.append(Odometry())  # empty frames, no length of the quaternion, no stamp
    return messages


def strange_twists():
    """Return a Twist with each strange number in each of its places."""
    twists = []
    for value, part, axis in itertools.product(STRANGE, ('linear', 'angular'), 'xyz'):
        twist = Twist()
        setattr(getattr(twist, part), axis, value)
        twists.append(twist)
    return twists


def publish_all(topic, kind, messages, *answers):
    """Publish messages once somebody listens, and once the answers are surely heard.

    For that the first message is repeated until it has been answered.
    """
    publisher = rospy.Publisher(topic, kind, queue_size=QUEUE_SIZE)
    wait_for_subscribers(publisher)
    for recorder in answers:
        wait_until(lambda heard=recorder: publisher.publish(messages[0]) or heard.last, 10.0,
                   'an answer')
    for message in messages:
        publisher.publish(message)
    return publisher


def test_the_detector_counts_on_through_strange_odometry(ns):
    """No message ends it, and the sum stays finite and never falls."""
    moved = Recorder(f'{ns}moved_distance', Float64)
    with detector() as node:
        publisher = publish_all(f'{ns}odom', Odometry, strange_odometry(), moved)
        for step in range(20):
            publisher.publish(odometry(x=0.01 * step, stamp=10000 + 0.05 * step))
        moved.wait_for(lambda m: m.data >= 0.18, what='the distance of the healthy messages')
        assert node.running
    distances = [message.data for message in moved.messages]
    assert all(math.isfinite(distance) for distance in distances)
    assert distances == sorted(distances)
    assert distances[-1] < 0.2
    assert 'Traceback' not in node.output


@pytest.mark.parametrize('start', [rotator, lambda: rosrun('rotate_robot', 'main.py')])
def test_strange_odometry_ends_neither_rotate_nor_main(ns, start):
    """And no command is other than finite and within the clamp."""
    commands = Recorder(f'{ns}cmd_vel', Twist)
    with start() as node:
        publisher = publish_all(f'{ns}odom', Odometry, strange_odometry())
        publisher.publish(odometry(yaw=0.26000001, stamp=20000))
        node.wait_for_output('0.26')
        assert node.running
    assert 'Traceback' not in node.output
    assert all(abs(message.angular.z) <= 3.14 for message in commands.messages)


def test_strange_distances_stop_the_mover(ns):
    """NaN and infinities command zero; the next healthy distance decides anew."""
    commands = Recorder(f'{ns}cmd_vel', Twist)
    with mover() as node:
        publish_all(f'{ns}moved_distance', Float64, [Float64(value) for value in STRANGE], commands)
        commands.wait_for(lambda m: m.linear.x > 0, what='a command to go on')
        wait_until(lambda: [m.linear.x for m in commands.messages][-4:] == [0.0, 0.1, 0.1, 0.1],
                   5.0, lambda: commands.messages)
        assert node.running


def test_strange_commands_leave_the_robot_finite_and_within_its_limits(ns):
    """Whatever is in a Twist: the robot stands, or moves as fast as a TurtleBot 2 can."""
    with simulator() as node:
        truth = Truth(ns)
        truth.wait_for(timeout=20.0)
        publish_all(f'{ns}cmd_vel', Twist, strange_twists())
        truth.wait_until_resting()
        assert node.running
    for message in truth.messages:
        position = message.pose.pose.position
        assert all(map(math.isfinite, (position.x, position.y, position.z)))
        assert speed(message) < 3.5
    assert node.output.count('is not finite') >= 1


def publish_at(topic, kind, rate, make, stop):
    """Publish make(k) at a rate (Hz) in a thread until the event `stop`."""
    publisher = rospy.Publisher(topic, kind, queue_size=QUEUE_SIZE)
    wait_for_subscribers(publisher)

    def work():
        for count in itertools.count():
            publisher.publish(make(count))
            if stop.wait(1 / rate):
                return

    thread = threading.Thread(target=work)
    thread.start()
    return thread


@pytest.mark.parametrize('rate, steps', [(1, 3), (1000, 3000)])
def test_no_distance_is_lost_at_slow_and_at_fast_odometry(ns, rate, steps):
    """Once a second and a thousand times a second, every step counts."""
    moved = Recorder(f'{ns}moved_distance', Float64)
    stop = threading.Event()
    with detector():
        publish_all(f'{ns}odom', Odometry, [odometry(stamp=1)], moved)
        thread = publish_at(f'{ns}odom', Odometry, rate,
                            lambda k: odometry(x=0.001 * k, stamp=2 + k / rate), stop)
        try:
            moved.wait_for(lambda m: m.data >= 0.001 * steps - 1e-9, 30.0, 'the whole way')
        finally:
            stop.set()
            thread.join()
    way = [message.data for message in moved.messages if message.data > 0]
    steps_seen = [after - before for before, after in zip(way, way[1:])]
    assert steps_seen == pytest.approx([0.001] * len(steps_seen), abs=1e-9)


def test_a_burst_after_a_gap_is_counted_whole(ns):
    """Ten seconds of odometry, held up on the way, arrive at once; no one of them is a jump."""
    moved = Recorder(f'{ns}moved_distance', Float64)
    with detector() as node:
        publish_all(f'{ns}odom', Odometry,
                    [odometry(stamp=1)] + [odometry(x=0.005 * k, stamp=11 + 0.05 * k)
                                           for k in range(200)], moved)
        moved.wait_for(lambda m: m.data == pytest.approx(0.995), what='the whole way')
    assert 'not counted' not in node.output


def test_two_publishers_at_once_are_jumps_and_not_metres(ns):
    """Two robots on one topic, a hundred metres apart: nothing moves, nothing is counted."""
    moved = Recorder(f'{ns}moved_distance', Float64)
    with detector() as node:
        publish_all(f'{ns}odom', Odometry, [odometry(x=100.0 * (k % 2), stamp=1 + 0.01 * k)
                                       for k in range(100)], moved)
        moved.wait_for_count(100)
        node.wait_for_output('not counted')
    assert moved.last.data == 0.0


def test_the_robot_obeys_the_last_of_two_thousand_commands_a_second(ns):
    """The simulator keeps its pace, and stops when they cease."""
    stop = threading.Event()
    with simulator() as node:
        truth = Truth(ns)
        truth.wait_for(timeout=20.0)
        command = Twist()
        command.linear.x = 0.2
        thread = publish_at(f'{ns}cmd_vel', Twist, 2000, lambda _: command, stop)
        try:
            truth.wait_until_moving()
            truth.wait_seconds(2.0)
        finally:
            stop.set()
            thread.join()
        truth.wait_until_resting()
        assert node.running


def test_a_kidnapped_robot_goes_on_to_two_metres(ns):
    """A teleport in the middle of the drive is no movement."""
    moved = Recorder(f'{ns}moved_distance', Float64)
    with detector() as node, mover():
        messages = [odometry(x=0.02 * k + (50.0 if k > 60 else 0.0), stamp=1 + 0.05 * k)
                    for k in range(120)]
        publish_all(f'{ns}odom', Odometry, messages, moved)
        moved.wait_for(lambda m: m.data == pytest.approx(0.02 * 118), what='both ways together')
        node.wait_for_output('not counted')
    assert max(message.data for message in moved.messages) < 2.4
