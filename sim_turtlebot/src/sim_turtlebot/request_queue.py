"""Requests of rospy's threads to the main thread, the only one that touches the robots."""

import queue
import threading

ANSWER_TIMEOUT = 5.0  # s


class RequestQueue(queue.SimpleQueue):
    """Functions without arguments, served one after the other."""

    def put_and_wait(self, request):
        """Add a request and wait until it has been served."""
        done = threading.Event()

        def serve():
            request()
            done.set()

        self.put(serve)
        done.wait(ANSWER_TIMEOUT)

    def serve(self, timeout):
        """Wait (s of wall time) for a request and serve it; return False if none came."""
        try:
            self.get(timeout=timeout)()
        except queue.Empty:
            return False
        return True
