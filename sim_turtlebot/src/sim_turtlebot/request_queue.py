"""Requests of rospy's threads, of which one at a time may touch the robots."""

import queue
import threading
from concurrent import futures
from functools import partial

ANSWER_TIMEOUT = 5.0  # s


class RequestQueue(queue.Queue):
    """Functions without arguments, served one after the other by the thread whose turn it is.

    That is the main thread, which takes some 40 us to wake up. While it has nothing to do but to
    wait, it can lend its turn: whoever brings a request then serves it at once.

    queue.SimpleQueue would be faster, but its get() may wait for ever: when the machine lets it
    stand for longer than its timeout before it begins to wait.
    """

    def __init__(self):
        """Give the turn to this thread, the main one."""
        super().__init__()
        self._turn = threading.Lock()
        self._turn.acquire()

    def put_and_wait(self, request):
        """Add a request and return once it has been served.

        :raises TimeoutError: after ANSWER_TIMEOUT; a request that has not begun by then is dropped,
            one that has begun still takes effect
        """
        answer = futures.Future()

        def serve():
            if answer.set_running_or_notify_cancel():
                request()
                answer.set_result(None)

        self.put(serve)
        if not futures.wait([answer], ANSWER_TIMEOUT).done:
            bound = f'within {ANSWER_TIMEOUT:g} s of wall time'
            raise TimeoutError(f'not begun {bound}, and dropped' if answer.cancel() else
                               f'not finished {bound}; it will still take effect')

    def serve_if_lent(self, request, then):
        """Serve a request on this thread, and call `then`, if the turn is lent; else put it.

        What either raises is raised on the main thread, too: rospy would only log it here.
        """
        if self._turn.acquire(blocking=False):
            try:
                if self.empty():
                    request()
                    then()
                    return
            except BaseException as error:
                self.put(partial(_raise, error))
                raise
            finally:
                self._turn.release()
        self.put(request)

    def serve(self, timeout):
        """Wait (s of wall time) for a request and serve it; return False if none came."""
        try:
            self.get(timeout=timeout)()
        except queue.Empty:
            return False
        return True

    def lend_turn(self, timeout):
        """Lend the turn until there is a request to serve (s of wall time); return whether there is."""
        if self.empty():
            self._turn.release()
            with self.not_empty:
                self.not_empty.wait_for(self._qsize, timeout)
            self._turn.acquire()
        return not self.empty()


def _raise(error):
    raise error
