"""What plain rospy does wrong, and our nodes do not; which connections exist."""

import contextlib
import threading
import types
from xmlrpc.client import ServerProxy

import pytest
import rosgraph
import rospy
from odometry_common.connections import is_connected
from odometry_common.rospy_fixes import fix_rospy
from odometry_tests.tutorial import detector
from odometry_tests.waiting import PATIENCE, TIMEOUT, Recorder, wait_until
from rosgraph_msgs.msg import Log
from rospy.impl.registration import RegManager
from rospy.impl.tcpros_base import TCPROSTransport
from std_msgs.msg import Empty

REQUEST = '[{}] Reason: new node registered with same name'  # as rosmaster words it


@pytest.mark.parametrize('news', [
    [('/odom', ['http://robot:1']), ('/odom', [])],
    [('/odom', ['http://robot:1']), ('/tf', ['http://robot:2']), ('/odom', [])]])
def test_an_answer_that_is_older_than_the_news_takes_no_publisher_away(master, news):
    """The news came before rospy's thread had time for the answer."""
    fix_rospy()
    connected = set()
    handler = types.SimpleNamespace(done=False, _connect_topic=lambda *link: connected.add(link) or (1, '', 0))
    manager = RegManager(handler)
    for topic, addresses in news:
        manager.publisher_update(topic, addresses)
    thread = threading.Thread(target=manager.run, daemon=True)
    thread.start()
    wanted = {(topic, address) for topic, addresses in news for address in addresses}
    wait_until(lambda: connected == wanted, 10.0, lambda: f'{wanted}; connected: {connected}')
    handler.done = True
    thread.join(10.0)
    assert not thread.is_alive()


def test_a_request_to_shut_down_for_another_node_is_not_obeyed(master):
    """One for this node is. The other one may have had this address before."""
    with detector('__name:=first') as node:
        node.wait_for_output('waiting for')
        with ServerProxy(rosgraph.Master('/test').lookupNode('/first')) as address:
            assert address.shutdown('/master', REQUEST.format('/second'))[0] == 1
            with contextlib.suppress(OSError):  # it may end before it answers
                address.shutdown('/master', REQUEST.format('/first'))
        assert node.wait() == 0
    assert '/first' in node.output
    assert '/second' not in node.output


@pytest.mark.parametrize('disabled', [True, False])
def test_the_master_forgets_a_node_that_has_ended(master, disabled):
    """One that has logged something, too, though rospy asks for a parameter with the first line."""
    rospy.set_param('/rosout_disable_topics_generation', disabled)
    log = Recorder('/rosout', Log)
    name = f'/disabled_{disabled}'
    with detector(f'__name:={name[1:]}') as node:
        line = log.wait_for(lambda m: m.name == name and 'waiting for' in m.msg)
        assert (line.topics == []) == disabled, line
        assert node.end() == 0
    assert 'counting' not in node.output, 'nothing has come'
    with pytest.raises(rosgraph.MasterError):
        rosgraph.Master('/test').lookupNode(name)


def test_a_subscriber_counts_as_connected_once_it_misses_nothing(master, monkeypatch):
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
