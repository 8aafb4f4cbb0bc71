"""Time that stops and goes back."""

import pytest
import rospy
from nav_msgs.msg import Odometry
from odometry_tests.pausing import call, pause
from odometry_tests.processes import rosrun
from odometry_tests.tutorial import (
    LONGEST_STEP,
    OVERSHOOT,
    Distance,
    Truth,
    detector,
    mover,
    simulator_in_step,
)
from odometry_tests.waiting import Recorder, wait_for_subscribers
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Empty

pytestmark = pytest.mark.usefixtures('simulated_time')


def x(recorder):
    return recorder.last.pose.pose.position.x


def test_neither_a_pause_nor_a_reset_is_movement_and_every_node_survives_them(master):
    """In mid-drive all stands; odometry starts from zero; time and robot go back to zero."""
    moved, truth, clock = Distance(), Truth(), Recorder('/clock', Clock)
    odometry = Recorder('odom', Odometry)
    reset = rospy.Publisher('mobile_base/commands/reset_odometry', Empty, queue_size=1)
    with simulator_in_step('_real_time_factor:=10'), detector() as counter, \
            mover('_distance:=0.6') as driver, rosrun('rotate_robot', 'main.py') as printer:
        wait_for_subscribers(reset)
        moved.wait_for(lambda m: m.data > 0.3, what='0.3 m')  # a jump is more than 0.25 m
        pause(moved, truth, clock)
        odometry.clear()
        reset.publish(Empty())
        call('unpause_physics')
        odometry.wait_for(lambda m: m.pose.pose.position.x < 0.05, what='odometry near zero')
        counter.wait_for_output('not counted')
        moved.wait_for(lambda m: m.data > 0.45, what='0.45 m')
        pause(moved, truth)
        before = moved.last.data
        assert x(truth) == pytest.approx(before, abs=LONGEST_STEP)
        call('reset_simulation')
        call('unpause_physics')
        arrived = moved.wait_until_arrived(0.6)
        assert arrived < 0.6 + OVERSHOOT
        assert x(truth) == pytest.approx(arrived - before, abs=LONGEST_STEP)
        assert all(process.running for process in (counter, driver, printer))
    assert min(moved.steps) >= 0 and max(moved.steps) < LONGEST_STEP
