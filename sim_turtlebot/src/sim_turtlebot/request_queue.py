"""Requests of rospy's threads, which the main thread serves: only it may touch the robots."""

import queue
import threading
from operator import itemgetter

ANSWER_TIMEOUT = 5.0  # s


class RequestQueue(queue.Queue):
    """Functions without arguments, with the names of their senders, for the main thread to serve.

    queue.SimpleQueue would be faster, but its get() may wait for ever: when the machine lets it
    stand for longer than its timeout before it begins to wait.
    """

    def put_and_wait(self, request, sender=''):
        """Add a request and wait until it has been served."""
        done = threading.Event()

        def serve():
            request()
            done.set()
            return True

        self.put((sender, serve))
        done.wait(ANSWER_TIMEOUT)

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
