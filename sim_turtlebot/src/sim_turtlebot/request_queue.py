"""Requests of rospy's threads, which the main thread serves: only it may touch the robots."""

import queue
from concurrent import futures
from operator import itemgetter

ANSWER_TIMEOUT = 5.0  # s


class RequestQueue(queue.Queue):
    """Functions without arguments, with the names of their senders, for the main thread to serve.

    queue.SimpleQueue would be faster, but its get() may never return, if the scheduler suspends it
    for longer than its timeout just before it waits.
    """

    def put_and_wait(self, request, sender=''):
        """Add a request and return once it has been served.

        :raises TimeoutError: after ANSWER_TIMEOUT; a request that has not begun by then is dropped,
            one that has begun still takes effect
        """
        answer = futures.Future()

        def serve():
            if not answer.set_running_or_notify_cancel():
                return False
            request()
            answer.set_result(None)
            return True

        self.put((sender, serve))
        if not futures.wait([answer], ANSWER_TIMEOUT).done:
            bound = f'within {ANSWER_TIMEOUT:g} s of wall time'
            raise TimeoutError(f'not begun {bound}, and dropped' if answer.cancel() else
                               f'not finished {bound}; it will still take effect')

    def serve(self, timeout):
        """Wait (s of wall time) for a request and serve it; return False if none came."""
        try:
            _, request = self.get(timeout=timeout)
        except queue.Empty:
            return False
        request()
        return True

    def wait(self, timeout):
        """Wait (s of wall time) for a request; return whether there is one."""
        with self.not_empty:
            return bool(self.not_empty.wait_for(self._qsize, timeout))

    def serve_all(self):
        """Serve all requests in the order of their senders; return whether one of these waited."""
        requests = [self.get() for _ in range(self.qsize())]
        waited = [request() for _, request in sorted(requests, key=itemgetter(0))]
        return any(waited)
