"""What a subscriber that is behind receives, and how long it keeps a publisher."""

import contextlib
import socket
import threading
import time

import pytest
from odometry_common.transport import BACKLOG, NonBlockingTransport, wait_for_slow_subscribers
from odometry_tests.waiting import PATIENCE, TIMEOUT
from rospy.exceptions import TransportTerminated
from rospy.impl.tcpros_pubsub import TCPROSPub
from std_msgs.msg import Empty

from odometry_common import transport

SIZE = 1000  # bytes of a message
COUNT = 2000  # messages; a socket holds some hundred of them


@pytest.fixture
def connection(monkeypatch):
    """Return a publisher's connection, as of a node, and the socket of its subscriber."""
    monkeypatch.setattr(NonBlockingTransport, 'wait_budget', 0.0)
    near, far = socket.socketpair()
    with contextlib.closing(NonBlockingTransport(TCPROSPub('/odom', Empty), '/odom')) as link, far:
        near.setblocking(True)  # as rospy does, which gives new sockets a timeout otherwise
        link.socket, link.endpoint_id = near, '/reader'
        far.settimeout(TIMEOUT * PATIENCE)
        yield link, far


@pytest.fixture
def warnings(monkeypatch):
    seen = []
    monkeypatch.setattr(transport.rospy, 'logwarn', seen.append)
    return seen


def write(link, numbers):
    for number in numbers:
        link.write_data(number.to_bytes(4, 'little').ljust(SIZE, b'.'))


def read(far, last):
    """Return the numbers of the messages up to the last one; each of them has to be whole."""
    numbers = []
    while numbers[-1:] != [last]:
        message = far.recv(SIZE, socket.MSG_WAITALL)
        assert message[4:] == b'.' * (SIZE - 4)
        numbers.append(int.from_bytes(message[:4], 'little'))
    return numbers


def test_one_that_does_not_read_loses_messages_but_neither_their_order_nor_the_last(
        connection, warnings):
    """It is named once; what it reads later are whole messages, the latest ones among them."""
    link, far = connection
    write(link, range(COUNT))
    numbers = read(far, COUNT - 1)
    assert numbers == sorted(set(numbers)) and len(numbers) < COUNT
    assert numbers[-BACKLOG:] == list(range(COUNT - BACKLOG, COUNT))
    assert warnings == ['/reader does not keep up with /odom: it loses messages']


def test_only_one_thread_sends_a_backlog(connection):
    """Also if a new backlog begins just as the thread that sent the last one finds nothing more."""
    link, far = connection
    begun = threading.Event()

    class Changed(threading.Condition):
        """Lets the publisher go on as soon as the thread that drains has sent everything."""

        def __exit__(self, *failure):
            super().__exit__(*failure)
            is_publisher = threading.current_thread() is threading.main_thread()
            if not (is_publisher or link._backlog or begun.is_set()):
                begun.set()
                refill = threading.Thread(target=write, args=[link, range(COUNT, 2 * COUNT)])
                refill.start()
                refill.join(TIMEOUT * PATIENCE)

    link._changed = Changed()
    write(link, range(COUNT))
    numbers = read(far, 2 * COUNT - 1)
    assert numbers == sorted(set(numbers))


def test_a_publisher_that_waits_loses_nothing_for_one_that_reads(connection, warnings):
    wait_for_slow_subscribers(TIMEOUT * PATIENCE)
    link, far = connection
    link._budget_left = link.wait_budget
    numbers = []
    reader = threading.Thread(target=lambda: numbers.extend(read(far, COUNT - 1)))
    reader.start()
    write(link, range(COUNT))
    reader.join(TIMEOUT * PATIENCE)
    assert numbers == list(range(COUNT)) and not warnings


def test_a_publisher_waits_no_longer_than_it_says(connection, warnings):
    """For one that does not read: all its messages together use up one budget."""
    wait_for_slow_subscribers(0.2)
    link, _ = connection
    start = time.monotonic()
    write(link, range(COUNT))
    assert link._budget_left == 0.0 and warnings
    assert time.monotonic() - start >= 0.2


def test_one_that_has_gone_is_forgotten(connection):
    link, far = connection
    write(link, range(COUNT))
    far.close()
    link.wait_until_sent(TIMEOUT * PATIENCE)
    with pytest.raises(TransportTerminated):
        write(link, range(COUNT))
