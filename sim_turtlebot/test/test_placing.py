"""A robot that is put somewhere, by a topic or by RViz's button: upright, or on its side."""

import pytest
import rospy
from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped
from odometry_tests.pausing import call
from odometry_tests.processes import rosrun
from odometry_tests.robots import ON_ITS_SIDE, place, pose
from odometry_tests.tutorial import Truth, simulator
from odometry_tests.waiting import TIMEOUT, Recorder, wait_for_subscribers, wait_until
from std_msgs.msg import String

THERE = 3.0, -1.0, 1.2  # m, m, rad
START = 0.0, 0.0, 0.0

pytestmark = pytest.mark.usefixtures('simulated_time')


def test_rviz_puts_it_where_it_is_said_to_be(ns):
    """By its button 2D Pose Estimate, in the frame world; in another one there is a warning.

    RViz does not show the log; the page shows ~warning, until a place is accepted.
    """
    with simulator() as node, rosrun('sim_turtlebot', 'world_frame.py'):
        warnings = Recorder(f'{ns}sim_turtlebot/warning', String)
        truth = Truth(ns)
        truth.wait_for()
        rviz = rospy.Publisher(f'{ns}initialpose', PoseWithCovarianceStamped, queue_size=10)
        wait_for_subscribers(rviz)
        message = PoseWithCovarianceStamped()
        message.pose.pose = pose(*THERE[:2], yaw=THERE[2]).pose
        message.header.frame_id = 'odom'

        def is_refused():
            rviz.publish(message)
            return warnings.last and "frame_id is 'odom', but must be world" in warnings.last.data

        wait_until(is_refused, TIMEOUT, lambda: f'a warning; there is:\n{node.output}', period=0.1)
        assert {place(m) for m in truth.messages} == {START}
        message.header.frame_id = 'world'
        rviz.publish(message)
        truth.wait_for(lambda m: place(m) == THERE, what=f'a robot at {THERE}')
        wait_until(lambda: 'refused' not in warnings.last.data, TIMEOUT, 'no warning any more')


def test_a_robot_on_its_side_is_warned_of_until_it_stands(ns):
    """In the log and for the page, which of them; at once also while time stands still."""
    # Without a pace nobody is warned that the machine is too slow for it.
    with simulator('_robots:=2', '_odometry_source:=encoder', '_real_time_factor:=0') as node:
        warnings = Recorder(f'{ns}sim_turtlebot/warning', String)
        warnings.wait_for(lambda m: m.data == '', what='no warning')
        first, second = (rospy.Publisher(f'{ns}sim_turtlebot/{robot}/set_pose', PoseStamped, queue_size=10)
                         for robot in ('robot_1', 'robot_2'))
        for publisher in first, second:
            wait_for_subscribers(publisher)
        second.publish(pose(-0.001, 3.0, 0.3, orientation=ON_ITS_SIDE))
        alone = warnings.wait_for(lambda m: m.data, what='a warning').data
        assert alone == 'robot_2 lies on its side at x 0, y 3; ~reset_simulation brings it back'
        Truth(f'{ns}robot_2/').wait_seconds(1.0)
        first.publish(pose(0.0, -2.0, 0.3, orientation=ON_ITS_SIDE))
        both = warnings.wait_for(lambda m: 'robot_1' in m.data, what='a second one').data
        assert both == f'{alone}; {alone.replace("robot_2", "robot_1").replace("y 3", "y -2")}'
        second.publish(pose(2.0, 3.0))
        warnings.wait_for(lambda m: 'robot_1' in m.data and 'robot_2' not in m.data,
                          what='robot_1 alone')
        call('pause_physics', ns)
        warnings.clear()
        call('reset_simulation', ns)
        warnings.wait_for(lambda m: m.data == '', what='no warning')
        assert node.end() == 0, node.output
    assert node.output.count('robot_2 lies on its side') == 1
    assert node.output.count('robot_1 lies on its side') == 1
