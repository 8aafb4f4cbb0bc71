"""What the simulator publishes, by the contract."""

import math

import rosgraph
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from odometry_tests.pausing import call
from odometry_tests.robots import place, twist
from odometry_tests.tutorial import Truth, simulator
from odometry_tests.waiting import Recorder, wait_for_subscribers
from rosgraph_msgs.msg import Clock
from tf2_msgs.msg import TFMessage

START = 1.0, -2.0, 1.5  # m, m, rad
TUTORIAL_VARIANCES = [1e-05, 1e-05, 1e12, 1e12, 1e12, 0.001]


def test_odometry_has_the_fields_of_the_tutorial_and_starts_at_zero(simulated_time):
    """Ground truth is in the world, odometry from the start on; its transform may be left to a filter."""
    odometry, truths, tf = Recorder('odom', Odometry), Truth(), Recorder('/tf', TFMessage)
    clock = Recorder('/clock', Clock)
    with simulator('_x:=1', '_y:=-2', '_yaw:=1.5', '_publish_tf:=false'):
        message, truth, frames = odometry.wait_for(), truths.wait_for(), tf.wait_for().transforms
        clock.wait_for_publisher()
        clock.clear()
        call('reset_simulation')
        clock.wait_for(lambda m: m.clock.to_nsec() == 1, what='the first tick: at zero rosbag record would end')
    assert {frame.child_frame_id for frame in frames} == {'wheel_left_link', 'wheel_right_link'}
    assert (message.header.frame_id, message.child_frame_id) == ('odom', 'base_footprint')
    assert list(message.pose.covariance[::7]) == TUTORIAL_VARIANCES
    assert sum(map(abs, message.pose.covariance)) == sum(TUTORIAL_VARIANCES)
    assert set(message.twist.covariance) == {0.0} and message.twist.twist == Twist()
    assert (truth.header.frame_id, truth.child_frame_id) == ('world', 'base_footprint')
    assert (place(truth), place(message)) == (START, (0.0, 0.0, 0.0))


def test_a_command_that_is_not_finite_is_refused_and_stops_the_robot(simulated_time):
    truth, publisher = Truth(), rospy.Publisher('cmd_vel', Twist, queue_size=10)
    with simulator('_cmd_vel_timeout:=0') as node:
        wait_for_subscribers(publisher)
        publisher.publish(twist(0.3, 0.5))
        truth.wait_until_moving()
        publisher.publish(twist(math.nan))
        truth.wait_until_resting()
        node.wait_for_output('is not finite')


def test_without_simulated_time_the_stamps_are_the_walls(master):
    rospy.set_param('/use_sim_time', False)
    start = rospy.Time.now()
    with simulator('__ns:=wall'):
        stamp = Recorder('/wall/odom', Odometry).wait_for(timeout=20.0).header.stamp
        publishers = dict(rosgraph.Master('/test').getSystemState()[0])
    assert start < stamp < rospy.Time.now()
    assert '/wall/sim_turtlebot' in publishers['/wall/odom']
    assert '/clock' not in publishers
    assert '/wall/scan' not in publishers, 'scan is off by default'
