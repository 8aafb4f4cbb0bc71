"""In lockstep a run as fast as the machine can has no control delay, and two are the same bytes."""

import signal

import pytest
from geometry_msgs.msg import Twist
from lockstep_runs import NOT_AWAITED, UNPACED, assert_same_bytes, record, step
from nav_msgs.msg import Odometry
from odometry_tests.tutorial import Truth, detector, is_at_rest, mover, rotator, simulator_in_step

SHORT = 5  # s of simulated time

pytestmark = pytest.mark.usefixtures('simulated_time')

ROTATE = [rotator], {'/odom': (Odometry, 20 * SHORT), '/cmd_vel': (Twist, 10 * SHORT)}


def test_steps_from_outside_move_the_robot_as_lockstep_does_by_itself():
    """To the byte, and each answers with the stamp of the odometry that it has published."""
    stamps = []

    def step_by_step():
        stamps.extend(answer.message for answer in step(20 * SHORT))

    stepped = record(*ROTATE, begin=step_by_step)
    assert_same_bytes(record(*ROTATE), stepped)
    assert stamps == [f'{message.header.stamp.to_sec():.9f}' for message in stepped['/odom']]


def test_a_mover_that_is_killed_does_not_stop_the_time():
    with simulator_in_step(UNPACED) as simulation, detector(), \
            mover('_distance:=100') as driver:
        truth = Truth()
        truth.wait_until_moving()
        driver.end(signal.SIGKILL)
        simulation.wait_for_output('the base stops: no command on /cmd_vel for 0.6 s')
        assert is_at_rest(truth.wait_seconds(10.0))
    assert NOT_AWAITED not in simulation.output
