"""Connections to subscribers that never block their publisher."""

import socket
import threading
import time
from collections import deque

import rospy
from rospy.exceptions import TransportTerminated
from rospy.impl.tcpros_base import TCPROSTransport

BACKLOG = 10  # messages kept for a subscriber whose socket is full
BUDGET_PER_MESSAGE = 0.01  # s


class NonBlockingTransport(TCPROSTransport):
    """Writes each message at once, or queues it while the subscriber's socket is full.

    rospy's own transport, and with it the publisher, blocks until the subscriber reads. Here a full
    backlog loses its oldest message.
    """

    wait_budget = 0.0  # s, see wait_for_slow_subscribers()

    def __init__(self, *arguments, **options):
        super().__init__(*arguments, **options)
        self._changed = threading.Condition()
        self._backlog = deque()  # a thread sends the first of it; a second one would mix bytes
        self._budget_left = self.wait_budget
        self._warned = False

    def write_data(self, data):
        """Send a serialized message, or queue it.

        :raises TransportTerminated: if the subscriber has gone; rospy then removes it
        """
        with self._changed:
            if self._backlog:
                self._queue(data)
            elif rest := self._send(data):
                self._backlog.append(rest)
                threading.Thread(target=self._drain, args=[rest], daemon=True).start()
            if self._backlog and self.wait_budget:
                self._wait()
        return True

    def wait_until_sent(self, timeout):
        """Wait (s of wall time) until nothing is queued."""
        with self._changed:
            self._changed.wait_for(lambda: not self._backlog, timeout)

    def _send(self, data):
        """Send what fits into the socket; return the rest."""
        try:
            sent = self.socket.send(data, socket.MSG_DONTWAIT)
        except BlockingIOError:
            sent = 0
        except (OSError, AttributeError) as error:  # no socket: closed on another thread
            self.close()
            raise TransportTerminated(str(error)) from None
        if sent == len(data):
            self._count(sent)
        return data[sent:]

    def _count(self, size):
        """Count a message whose last byte has been sent."""
        self.stat_bytes += size
        self.stat_num_msg += 1
        self._budget_left = min(self.wait_budget, self._budget_left + BUDGET_PER_MESSAGE)

    def _queue(self, data):
        if len(self._backlog) > BACKLOG:
            del self._backlog[1]
            if not self._warned:
                self._warned = True
                rospy.logwarn(
                    f'{self.endpoint_id} does not keep up with {self.name}: it loses messages')
        self._backlog.append(data)

    def _drain(self, data):
        """Send the rest of a message, then the backlog."""
        try:
            while data:
                self.socket.sendall(data)
                data = self._next(len(data))
        except (OSError, AttributeError):  # the subscriber or this node is shutting down
            self.close()
            with self._changed:
                self._backlog.clear()
                self._changed.notify_all()

    def _next(self, size):
        """Count `size` sent bytes; return the next message, or None, which ends the draining."""
        with self._changed:
            self._count(size)
            self._backlog.popleft()
            self._changed.notify_all()
            return self._backlog[0] if self._backlog else None

    def _wait(self):
        start = time.monotonic()
        self.wait_until_sent(self._budget_left)
        self._budget_left = max(0.0, self._budget_left - (time.monotonic() - start))


def wait_for_slow_subscribers(budget):
    """Make publishers wait for slow subscribers, so that a subscriber that reads loses nothing.

    :param budget: how long to wait for one subscriber (s of wall time), plus BUDGET_PER_MESSAGE for
        each message that it takes
    """
    NonBlockingTransport.wait_budget = budget


def flush(publisher, timeout):
    """Wait (s of wall time) until the queue of a rospy.Publisher is empty."""
    end = time.monotonic() + timeout
    for connection in publisher.impl.connections:
        if isinstance(connection, NonBlockingTransport):
            connection.wait_until_sent(max(0.0, end - time.monotonic()))
