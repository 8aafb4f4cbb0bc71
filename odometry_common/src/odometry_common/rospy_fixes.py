"""Fixes for defects of rospy that lose messages, hang a node, or shut down another node."""

import contextlib
import re
import threading

import rospy
from rospy.impl import tcpros_pubsub
from rospy.impl.masterslave import ROSHandler
from rospy.impl.paramserver import get_param_server_cache
from rospy.impl.registration import RegManager
from rospy.impl.tcpros_base import TCPROSServer

from odometry_common.connections import NO_ANSWER
from odometry_common.transport import NonBlockingTransport

HEADER_TIMEOUT = 5.0  # s, for a peer that connects and sends no header
# As rosmaster/registrations.py words it.
REPLACED = re.compile(r'\[(?P<name>/.+)\] Reason: new node registered with same name')
ROSOUT_PARAMETER = '/rosout_disable_topics_generation'

_shutdown = ROSHandler.shutdown
_accept_subscriber = TCPROSServer._tcp_server_callback


def fix_rospy():
    """Fix rospy for this process; call it before rospy.init_node, once the master answers."""
    TCPROSServer._tcp_server_callback = _accept_on_thread
    tcpros_pubsub.TCPROSTransport = NonBlockingTransport
    RegManager.publisher_update = _add_publishers
    ROSHandler.shutdown = _shut_down_if_meant
    _leave_no_address_behind()


def _accept_on_thread(server, connection, address):
    """Read a subscriber's header on a new thread.

    rospy reads all headers on one thread: a peer that sends none blocks every later subscriber.
    """
    connection.settimeout(HEADER_TIMEOUT)  # rospy makes it blocking again after the header
    threading.Thread(
        target=_accept_subscriber, args=[server, connection, address], daemon=True).start()


def _add_publishers(manager, topic, addresses):
    """Queue the publishers of a topic together with those that still wait in the queue.

    The master answers a new subscriber with the publishers of its topic, and sends later ones as
    updates. If the first update overtakes the answer, rospy takes the older answer for the latest
    list, and never connects to the new publisher. A publisher that has gone meanwhile does no harm:
    rospy fails to connect to it.
    """
    with manager.cond:
        waiting = [address for name, others in manager.updates if name == topic
                   for address in others]
        manager.updates.append((topic, list(dict.fromkeys([*waiting, *addresses]))))
        manager.cond.notify_all()


def _shut_down_if_meant(handler, caller_id, reason=''):
    """Obey a request to shut down, unless it is for another node.

    When a node registers a name that an earlier node had, the master asks the last known address of
    the earlier one to shut down. That port may now belong to another node, even of another master:
    the operating system hands out the same ports again after a few hundred nodes.
    """
    request = REPLACED.fullmatch(reason)
    if request and request['name'] != rospy.get_name():
        return 1, f'this is {rospy.get_name()}', 0
    return _shutdown(handler, caller_id, reason)


def _leave_no_address_behind():
    """Cache a parameter to which rospy would subscribe with its first log line.

    rospy never unsubscribes from it. The master then keeps the address of each node that has
    exited, and later asks the next node at that address to shut down.
    """
    with contextlib.suppress(*NO_ANSWER):
        value = rospy.get_param(ROSOUT_PARAMETER, False)
        get_param_server_cache().set(ROSOUT_PARAMETER, value)
