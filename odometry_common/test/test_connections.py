"""Which connections exist, while one is being made."""

import threading

import rospy
from odometry_common.connections import is_connected
from odometry_tests.waiting import PATIENCE, TIMEOUT, wait_until
from rospy.impl.tcpros_base import TCPROSTransport
from std_msgs.msg import Empty


def test_a_subscriber_counts_as_connected_once_it_misses_nothing(master, monkeypatch):
    """Rospy counts the connection before."""
    may_connect, heard = threading.Event(), threading.Event()
    connect = TCPROSTransport.connect

    def connect_late(*arguments, **options):
        assert may_connect.wait(TIMEOUT * PATIENCE)
        connect(*arguments, **options)

    monkeypatch.setattr(TCPROSTransport, 'connect', connect_late)
    publisher = rospy.Publisher('/late', Empty, queue_size=1)
    subscriber = rospy.Subscriber('/late', Empty, lambda _: heard.set())
    wait_until(subscriber.get_num_connections, TIMEOUT, 'a connection that rospy counts')
    assert not is_connected(subscriber)
    may_connect.set()
    wait_until(lambda: is_connected(subscriber), TIMEOUT, 'a connection')
    publisher.publish(Empty())
    assert heard.wait(TIMEOUT * PATIENCE)
    publisher.unregister()
    wait_until(lambda: not is_connected(subscriber), TIMEOUT, 'an end of it')
    subscriber.unregister()
