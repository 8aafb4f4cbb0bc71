"""A node is registered soon, and connects to each publisher that the master has named."""

import threading

import pytest
from odometry_common.registration import mend_registration
from odometry_tests.waiting import PATIENCE, TIMEOUT, wait_until
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
    mend_registration()
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


class Registering:
    """Stands for a RegManager that is not registered yet when it is first asked."""

    def __init__(self):
        """Begin without a question."""
        self._answers = iter([False, False, True, True])

    @property
    def registered(self):
        """Whether it is registered by now."""
        return next(self._answers)


def test_a_node_goes_on_as_soon_as_it_is_registered(monkeypatch):
    """With one question of rospy's, which asks again a tenth of a second later."""
    monkeypatch.setattr('odometry_common.registration.REGISTRATION_TIME', TIMEOUT * PATIENCE)
    mend_registration()
    assert RegManager.is_registered(Registering())


def test_rospy_is_told_that_a_node_is_not_registered_yet(monkeypatch):
    """It must be able to end meanwhile."""
    monkeypatch.setattr('odometry_common.registration.REGISTRATION_TIME', 0.0)
    mend_registration()
    assert not RegManager.is_registered(Registering())
