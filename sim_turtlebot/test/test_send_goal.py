"""When send_goal.py sends its goal; the test is the clock, and move_base."""

from functools import partial

import pytest
import rospy
from geometry_msgs.msg import PoseStamped
from odometry_common.orientation import yaw_from_orientation
from odometry_tests.messages import stamp
from odometry_tests.partners import START_TIME
from odometry_tests.processes import rosrun
from odometry_tests.waiting import Recorder, wait_for_subscribers
from std_msgs.msg import Empty

WAIT = 2.0  # s
GOAL = 1.0, -2.0, 0.6  # m, m, rad
START = partial(rosrun, 'sim_turtlebot', 'send_goal.py', f'_time:={START_TIME + WAIT}',
                *(f'_{name}:={value}' for name, value in zip(('x', 'y', 'yaw'), GOAL)))


@pytest.mark.parametrize('ready', [0.5, WAIT + 0.5])
def test_the_goal_leaves_at_its_time_or_once_move_base_takes_goals(ns, node, clock, ready):
    """Until move_base has its first status, it takes none."""
    goals = Recorder(f'{ns}move_base_simple/goal', PoseStamped)
    goals.wait_for_publisher()
    status = rospy.Publisher(f'{ns}move_base/status', Empty, queue_size=1)
    wait_for_subscribers(status)
    clock.advance(ready)
    status.publish()
    clock.advance(*[0.1] * round((WAIT - ready) / 0.1))
    goal = goals.wait_for()
    assert stamp(goal) == pytest.approx(START_TIME + max(WAIT, ready))
    assert goal.header.frame_id == 'map'
    position, yaw = goal.pose.position, yaw_from_orientation(goal.pose.orientation)
    assert (position.x, position.y, yaw) == pytest.approx(GOAL)
