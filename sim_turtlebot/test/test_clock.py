"""The clock ticks as finely as clients' own loops need it, or as asked. /tf can be left to a filter."""

import pytest
from odometry_tests.tutorial import simulator
from odometry_tests.waiting import Recorder
from rosgraph_msgs.msg import Clock
from tf2_msgs.msg import TFMessage

TICKS = 200


@pytest.mark.parametrize('arguments, period', [
    ([], 5), (['_real_time_factor:=10'], 10), (['_real_time_factor:=0'], 50),
    (['_real_time_factor:=0', '_clock_rate:=500'], 2)])
def test_the_clock_ticks_with_this_period(simulated_time, arguments, period):
    """In ms; a message that gets lost makes a gap, and none makes it shorter."""
    with simulator(*arguments):
        seen = [message.clock.to_nsec() for message in Recorder('/clock', Clock).wait_for_count(TICKS)]
    assert all(time % (period * 10**6) == 0 for time in seen)
    assert min(later - sooner for sooner, later in zip(seen, seen[1:])) == period * 10**6


def test_a_filter_may_publish_the_transform_of_the_odometry(simulated_time):
    """As robot_localization does; two publishers of one transform would make it jump."""
    transforms = Recorder('/tf', TFMessage)
    with simulator('_publish_tf:=false'):
        children = {transform.child_frame_id for transform in transforms.wait_for().transforms}
    assert children == {'wheel_left_link', 'wheel_right_link'}
