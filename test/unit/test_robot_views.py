"""What the system tests read from a robot's messages."""

import math

import pytest
from geometry_msgs.msg import Quaternion
from odometry_tests.messages import odometry
from odometry_tests.robots import place
from odometry_tests.tutorial import heading


@pytest.mark.parametrize('degrees', [-170, -90, 0, 45, 179])
@pytest.mark.parametrize('sign', [1, -1])
def test_a_heading_is_the_same_for_a_quaternion_and_its_negative(degrees, sign):
    """A robot that has turned by more than half a circle publishes the negative one."""
    half = math.radians(degrees) / 2
    message = odometry()
    message.pose.pose.orientation = Quaternion(z=sign * math.sin(half), w=sign * math.cos(half))
    assert heading(message) == pytest.approx(degrees)
    assert place(message) == (0.0, 0.0, round(math.radians(degrees), 2))
