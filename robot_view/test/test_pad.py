"""The pad and a robot that subscribes late."""

import math

import pytest
import rosgraph
from geometry_msgs.msg import Twist
from odometry_tests.waiting import TIMEOUT, Recorder, wait_until
from robot_view.steering import FORWARD, STOP

from robot_view import pad


@pytest.mark.parametrize('button', [STOP, FORWARD])
def test_a_button_released_before_the_robot_subscribes_stops_it(master, monkeypatch, button):
    """To connect takes a moment, on a busy machine longer than a click."""
    monkeypatch.setattr(pad, 'LONGEST_CONNECTING', math.inf)
    namespace = f'/late_for_{button}/'
    driver = pad.Pad(lambda: namespace, lambda: (0.2, 1.0))

    def is_advertised():
        driver.hold('page', button)
        return f'{namespace}cmd_vel' in dict(rosgraph.Master('/test').getSystemState()[0])

    wait_until(is_advertised, TIMEOUT, 'a publisher of cmd_vel')
    driver.release('page')
    received = Recorder(f'{namespace}cmd_vel', Twist)
    assert received.wait_for() == Twist()
