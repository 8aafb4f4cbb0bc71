"""How long the detector takes to answer, beside a relay that only passes messages on."""

import time
from contextlib import closing
from pathlib import Path
from statistics import median, quantiles

import rospy
from measuring import Target, compare, in_turns
from nav_msgs.msg import Odometry
from odometry_common.publishing import advertise
from odometry_launch.process_guard import GuardedProcess
from odometry_tests.messages import odometry
from odometry_tests.processes import Process
from odometry_tests.tutorial import detector, forget_parameters
from odometry_tests.waiting import wait_for_subscribers, wait_until
from std_msgs.msg import Float64

RELAY = Path(__file__).with_name('relay.py')
TIMEOUT = 30.0  # s
WARM_UP = 20  # messages
STEP = 0.001  # m


def detector_latency(options):
    """Measure the time from /odom to /moved_distance at a slow and at a fast rate."""
    for rate in (20, 500):
        yield from _latency(options, rate)


def _latency(options, rate):
    forget_parameters()
    count = min(options.messages, rate * options.longest)
    with detector(start=GuardedProcess), Process('python3', RELAY, '/relayed/odom', '/relayed/answer'), \
            closing(Answers('/odom', '/moved_distance', Float64)) as answers, \
            closing(Answers('/relayed/odom', '/relayed/answer', Odometry)) as relay:
        pairs = in_turns(options.runs, lambda: answers.times(rate, count),
                         lambda: relay.times(rate, count))
    yield compare(f'latency at {rate} Hz, median', 'ms',
                  [(median(value), median(limit)) for value, limit in pairs],
                  Target('<=', 1.15))
    yield compare(f'latency at {rate} Hz, 99th percentile', 'ms',
                  [(_percentile(value), _percentile(limit)) for value, limit in pairs],
                  Target('<=', 1.5))


class Answers:
    """Odometry to a node, and the times at which it answers."""

    def __init__(self, question, answer, answer_class):
        """Connect to the node by the two topics."""
        self._arrivals = []
        self._x = 0.0
        self._publisher = advertise(question, Odometry)
        self._subscriber = rospy.Subscriber(answer, answer_class, self._on_answer,
                                            tcp_nodelay=True)
        wait_for_subscribers(self._publisher, timeout=TIMEOUT)
        # The answers may be connected later than the questions.
        wait_until(self._is_answered, TIMEOUT, f'an answer on {answer}')

    def close(self):
        """Ask no more."""
        self._publisher.unregister()
        self._subscriber.unregister()

    def times(self, rate, count):
        """Send `count` messages at `rate` Hz; return the time until each one's answer (ms)."""
        del self._arrivals[:]
        departures = [self._send_at(start) for start in _schedule(rate, count + WARM_UP)]
        wait_until(lambda: len(self._arrivals) == len(departures), TIMEOUT,
                   lambda: f'{len(departures)} answers; there were {len(self._arrivals)}')
        return [1e3 * (arrival - departure) for departure, arrival
                in zip(departures[WARM_UP:], self._arrivals[WARM_UP:])]

    def _send_at(self, start):
        """Send a message at a time, and return when it was really sent."""
        self._x += STEP
        message = odometry(self._x, stamp=rospy.get_time())
        time.sleep(max(0.0, start - time.perf_counter()))
        departure = time.perf_counter()
        self._publisher.publish(message)
        return departure

    def _is_answered(self):
        self._publisher.publish(odometry(stamp=rospy.get_time()))
        return self._arrivals

    def _on_answer(self, _):
        self._arrivals.append(time.perf_counter())


def _schedule(rate, count):
    """Return the times at which to send so many messages."""
    start = time.perf_counter()
    return [start + index / rate for index in range(count)]


def _percentile(values):
    """Return the 99th percentile."""
    return quantiles(values, n=100)[-1]
