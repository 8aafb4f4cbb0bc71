"""Requests from rospy's threads; the main thread serves them, since only it may touch the robots."""

import contextlib
import itertools
import threading
from concurrent import futures

ANSWER_TIMEOUT = 5.0  # s


class RequestQueue:
    """Functions without arguments, by sender, for the main thread to call.

    Only the latest message of each sender and topic waits, so a flood delays no other sender.
    """

    def __init__(self):
        self._changed = threading.Condition()
        self._waiting = {}  # functions by sender
        self._numbers = itertools.count()
        self._held = ()  # names of topics and services that are not served now

    @property
    def nodes(self):
        """The names of the nodes whose messages are waiting."""
        with self._changed:
            return {sender[0] for sender in self._waiting if len(sender) == 2}

    def put(self, sender, request):
        """Add a request; it replaces an earlier one of the same sender.

        :param sender: a tuple of names: of the node, and of its topic
        """
        with self._changed:
            self._waiting.pop(sender, None)  # the new one is the last in order
            self._waiting[sender] = request
            self._changed.notify()

    def put_and_wait(self, sender, request):
        """Add a request and return its result once it has been served.

        :param sender: a tuple of names: of the node, and of the service
        :raises TimeoutError: after ANSWER_TIMEOUT; a request that has started by then still takes
            effect, another is dropped
        """
        answer = futures.Future()

        def serve():
            if not answer.set_running_or_notify_cancel():
                return False
            answer.set_result(request())
            return True

        self.put((*sender, next(self._numbers)), serve)
        if not futures.wait([answer], ANSWER_TIMEOUT).done:
            bound = f'within {ANSWER_TIMEOUT:g} s of wall time'
            raise TimeoutError(f'not begun {bound}, and dropped' if answer.cancel() else
                               f'not finished {bound}; it will still take effect')
        return answer.result()

    @contextlib.contextmanager
    def holding(self, *names):
        """Meanwhile do not serve requests for these topics and services."""
        self._held = names
        try:
            yield
        finally:
            self._held = ()

    def wait(self, timeout):
        """Wait (s of wall time) for a request; return whether there is one."""
        with self._changed:
            return self._changed.wait_for(lambda: bool(self._waiting), timeout)

    def serve_all(self, by_name=False):
        """Serve the waiting requests in order of arrival.

        :param by_name: in order of their senders' names instead
        :return: whether a service call was among them
        """
        with self._changed:
            waiting, self._waiting = self._waiting, {
                sender: request for sender, request in self._waiting.items() if sender[1] in self._held}
        senders = [sender for sender in (sorted(waiting) if by_name else waiting)
                   if sender[1] not in self._held]
        answered = [waiting[sender]() for sender in senders]
        return any(answered)
