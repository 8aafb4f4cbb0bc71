"""The latency of a node: from odometry to its answer."""

import contextlib
import itertools
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


@contextlib.contextmanager
def answering(namespace):
    """Yield a function that measures the latency (ms) of the node in a namespace."""
    arrivals, places = [], itertools.count(step=STEP)
    publisher = advertise(f'{namespace}odom', Odometry)
    subscriber = rospy.Subscriber(f'{namespace}moved_distance', Float64,
                                  lambda _: arrivals.append(time.perf_counter()), tcp_nodelay=True)

    def send_at(moment):
        message = odometry(next(places), stamp=rospy.get_time())
        time.sleep(max(0.0, moment - time.perf_counter()))
        departure = time.perf_counter()
        publisher.publish(message)
        return departure

    def latency():
        arrivals.clear()
        start = time.perf_counter()
        departures = [send_at(start + PERIOD * number) for number in range(WARM_UP + MESSAGES)]
        wait_until(lambda: len(arrivals) == len(departures), TIMEOUT,
                   lambda: f'{len(departures)} answers; there were {len(arrivals)}')
        return median(1e3 * (arrival - departure) for departure, arrival
                      in zip(departures[WARM_UP:], arrivals[WARM_UP:]))

    wait_for_subscribers(publisher, timeout=TIMEOUT)
    # The answers may be connected later than the questions.
    wait_until(lambda: send_at(0.0) and arrivals, TIMEOUT, f'an answer in {namespace}')
    yield latency
    publisher.unregister()
    subscriber.unregister()
