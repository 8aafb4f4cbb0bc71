"""The latency of a node: from odometry to its answer."""

import time
from statistics import median

import rospy
from graph import TIMEOUT
from nav_msgs.msg import Odometry
from odometry_common.publishing import advertise
from odometry_tests.messages import odometry
from odometry_tests.waiting import wait_for_subscribers, wait_until
from std_msgs.msg import Float64

PERIOD = 0.05  # s
MESSAGES, WARM_UP = 60, 20
STEP = 0.001  # m


class Answers:
    """Odometry to a node, and the times at which it answers."""

    def __init__(self, namespace):
        self._arrivals = []
        self._x = 0.0
        self._publisher = advertise(f'{namespace}odom', Odometry)
        self._subscriber = rospy.Subscriber(f'{namespace}moved_distance', Float64, self._on_answer, tcp_nodelay=True)
        wait_for_subscribers(self._publisher, timeout=TIMEOUT)
        # The answers may be connected later than the questions.
        wait_until(lambda: self._publisher.publish(odometry(stamp=rospy.get_time())) or self._arrivals,
                   TIMEOUT, f'an answer in {namespace}')

    def close(self):
        self._publisher.unregister()
        self._subscriber.unregister()

    def latency(self):
        del self._arrivals[:]
        start = time.perf_counter()
        departures = [self._send_at(start + PERIOD * number) for number in range(WARM_UP + MESSAGES)]
        wait_until(lambda: len(self._arrivals) == len(departures), TIMEOUT,
                   lambda: f'{len(departures)} answers; there were {len(self._arrivals)}')
        return median(1e3 * (arrival - departure) for departure, arrival
                      in zip(departures[WARM_UP:], self._arrivals[WARM_UP:]))

    def _send_at(self, moment):
        self._x += STEP
        message = odometry(self._x, stamp=rospy.get_time())
        time.sleep(max(0.0, moment - time.perf_counter()))
        departure = time.perf_counter()
        self._publisher.publish(message)
        return departure

    def _on_answer(self, _):
        self._arrivals.append(time.perf_counter())
