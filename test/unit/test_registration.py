"""A node connects to each publisher that the master has named, in whatever order it hears of them."""

import threading

import pytest
from odometry_common.registration import remember_publishers
from odometry_tests.waiting import wait_until
from rospy.impl.registration import RegManager


class Handler:
    """Stands for rospy's connections: keeps what it is to connect."""

    def __init__(self):
        """Begin without any."""
        self.done = False
        self.connected = set()

    def _connect_topic(self, topic, address):
        self.connected.add((topic, address))
        return 1, '', 0


@pytest.mark.parametrize('news', [
    [('/odom', ['http://robot:1']), ('/odom', [])],
    [('/odom', ['http://robot:1', 'http://robot:2']), ('/odom', ['http://robot:2'])],
    [('/odom', ['http://robot:1']), ('/tf', ['http://robot:2']), ('/odom', [])]])
def test_an_answer_that_is_older_than_the_news_takes_no_publisher_away(news):
    """They were told before rospy's thread had time for the first."""
    remember_publishers()
    handler = Handler()
    manager = RegManager(handler)
    for topic, addresses in news:
        manager.publisher_update(topic, addresses)
    thread = threading.Thread(target=manager.run, daemon=True)
    thread.start()
    wanted = {(topic, address) for topic, addresses in news for address in addresses}
    wait_until(lambda: handler.connected == wanted, 10.0,
               lambda: f'{wanted}; connected: {handler.connected}')
    handler.done = True
    thread.join(10.0)
    assert not thread.is_alive()
