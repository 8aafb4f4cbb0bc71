"""Two robots in one world, each with its own detector and mover."""

import pytest
from odometry_tests.processes import Process
from odometry_tests.tutorial import Distance, Truth, speed

ROBOTS = {'/robot_1/': 0.0, '/robot_2/': 1.0}  # namespace: start (m) to the left


def test_both_drive_two_metres(master):
    """As fast as the machine can, without a control delay."""
    with Process('roslaunch', 'odometry_launch', 'move_two_meters.launch', 'robots:=2',
                 'lockstep:=true', 'real_time_factor:=0'):
        distances = {name: Distance(name) for name in ROBOTS}
        truths = {name: Truth(name) for name in ROBOTS}
        for name, left in ROBOTS.items():
            moved = distances[name].wait_until_arrived(2.0)
            assert 2.0 <= moved <= 2.01
            truths[name].clear()
            position = truths[name].wait_for(lambda m: speed(m) == 0, what='rest').pose.pose.position
            assert position.x == pytest.approx(moved, abs=0.001)
            assert position.y == pytest.approx(left, abs=0.002)
