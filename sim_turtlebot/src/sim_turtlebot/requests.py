"""Requests from rospy's threads to the main thread, since only it may touch the robots."""

import threading
import time
from concurrent import futures

from sim_turtlebot.lockstep.budgets import STALL_TIMEOUT

ANSWER_TIMEOUT = STALL_TIMEOUT + 5.0  # s; before that lockstep goes on without a stalled process


class RequestQueue:
    """Functions without arguments, from topics and services, for the main thread to call.

    Only the latest message of each node and topic waits, so a flood delays no other node.
    """

    def __init__(self):
        self._changed = threading.Condition()
        self._messages = {}  # time of arrival (monotonic, s) and function, by node and topic
        self._calls = []  # node, service, function and Future of its result
        self._is_serving_calls = False

    @property
    def arrivals(self):
        """When the latest waiting message of each node came (monotonic, s), by name of the node."""
        with self._changed:
            return {node: arrival for (node, _), (arrival, _) in self._messages.items()}

    def put(self, node, topic, request):
        """Add a message's request; it replaces an earlier one of the same node and topic."""
        with self._changed:
            self._messages.pop((node, topic), None)  # the new one is the last in order
            self._messages[node, topic] = time.monotonic(), request
            self._changed.notify()

    def call(self, node, service, request):
        """Add a call's request and return its result once it has been served.

        :raises TimeoutError: after ANSWER_TIMEOUT; a request that has started by then still takes
            effect, another is dropped
        """
        answer = futures.Future()
        with self._changed:
            self._calls.append((node, service, request, answer))
            self._changed.notify()
        if not futures.wait([answer], ANSWER_TIMEOUT).done:
            bound = f'within {ANSWER_TIMEOUT:g} s of wall time'
            raise TimeoutError(f'not begun {bound}, and dropped' if answer.cancel() else
                               f'not finished {bound}; it will still take effect')
        return answer.result()

    def wait(self, timeout):
        """Wait (s of wall time) for a request; return whether there is one."""
        with self._changed:
            return self._changed.wait_for(lambda: bool(self._messages or self._calls), timeout)

    def serve_all(self, by_name=False):
        """Serve the waiting messages, then the waiting calls, each in order of arrival.

        While it serves a call, this serves messages only.

        :param by_name: in order of the names of their nodes, topics and services instead; robots
            are placed, then odometry is reset, and then they are commanded
        :return: whether a call was among them
        """
        with self._changed:
            messages, self._messages = self._messages, {}
            calls = []
            if not self._is_serving_calls:
                calls, self._calls = self._calls, []
        if by_name:
            calls.sort(key=lambda call: call[:2])
        for sender in sorted(messages, key=_order) if by_name else messages:
            _, request = messages[sender]
            request()
        for _, _, request, answer in calls:
            if answer.set_running_or_notify_cancel():  # else the caller has given up
                self._is_serving_calls = True
                answer.set_result(request())
                self._is_serving_calls = False
        return bool(calls)


def _order(sender):
    """Return the sort key of a node and a topic."""
    node, topic = sender
    kind = topic.rpartition('/')[2]
    return kind != 'set_pose', kind != 'reset_odometry', node, topic
