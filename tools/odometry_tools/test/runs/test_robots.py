"""The first tutorial with two robots in one world."""

import pytest
from odometry_tests.processes import Process
from odometry_tests.tutorial import Truth
from odometry_tests.waiting import PATIENCE, Recorder
from std_msgs.msg import Float64

STARTS = {'/robot_1/': 0.0, '/robot_2/': 1.0}  # by namespace: m to the left


def test_each_moves_two_metres_and_rests(master):
    """Ctrl-C on roslaunch: every node ends by itself, none is killed."""
    distances = {name: Recorder(f'{name}moved_distance', Float64) for name in STARTS}
    with Process('roslaunch', f'--sigint-timeout={15 * PATIENCE}', 'odometry_launch',
                 'move_two_meters.launch', 'robots:=2', 'lockstep:=true', 'real_time_factor:=0') as launch:
        for name, left in STARTS.items():
            distances[name].wait_for(lambda message: message.data >= 2.0, 40.0, '2 m')
            place = Truth(name).wait_until_resting().pose.pose.position
            assert place.y == pytest.approx(left, abs=0.002)
            moved = distances[name].wait_for(lambda message, x=place.x: abs(message.data - x) <= 0.001, 40.0,
                                             f'the way to x {place.x:.4f} m')
            assert 2.0 <= moved.data <= 2.01
        assert launch.end() == 0
    assert 'escalating' not in launch.output
