"""The pad of the page and a robot that is slow to hear it."""

import math
import time

import pytest
from geometry_msgs.msg import Twist
from odometry_tests.waiting import Recorder
from robot_view import pad
from robot_view.steering import FORWARD, HOLD_TIMEOUT, STOP


@pytest.mark.parametrize('button', [STOP, FORWARD])
def test_what_was_clicked_before_the_robot_heard_it_stops_it(master, monkeypatch, button):
    """To connect takes a moment, and on a busy machine longer than a click."""
    monkeypatch.setattr(pad, 'LONGEST_CONNECTING', math.inf)
    driver = pad.Pad(lambda: (0.2, 1.0))
    driver.choose(lambda: f'/late_for_{button}/')
    driver.hold('page', button)
    time.sleep(2 * HOLD_TIMEOUT)  # the click is over
    heard = Recorder(f'/late_for_{button}/cmd_vel', Twist)
    assert heard.wait_for() == Twist()
