"""The pad of the page and a robot that is slow to hear it."""

import math

import pytest
import rosgraph
from geometry_msgs.msg import Twist
from odometry_tests.waiting import TIMEOUT, Recorder, wait_until
from robot_view import pad
from robot_view.steering import FORWARD, STOP


def is_advertised(topic):
    """Return whether the master knows a publisher of a topic."""
    published, _, _ = rosgraph.Master('/test').getSystemState()
    return topic in dict(published)


@pytest.mark.parametrize('button', [STOP, FORWARD])
def test_what_was_clicked_before_the_robot_heard_it_stops_it(master, monkeypatch, button):
    """To connect takes a moment, and on a busy machine longer than a click."""
    monkeypatch.setattr(pad, 'LONGEST_CONNECTING', math.inf)
    topic = f'/late_for_{button}/cmd_vel'
    driver = pad.Pad(lambda: (0.2, 1.0))
    driver.choose(lambda: f'/late_for_{button}/')
    wait_until(lambda: driver.hold('page', button) or is_advertised(topic), TIMEOUT,
               f'a publisher of {topic}')
    driver.release('page')
    heard = Recorder(topic, Twist)
    assert heard.wait_for() == Twist()
