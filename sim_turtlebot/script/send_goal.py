#!/usr/bin/env python3
"""Send a goal to move_base at a simulated time, in lockstep the same in each run.

Subscribes:
    move_base/status (actionlib_msgs/GoalStatusArray): once it arrives, move_base takes goals

Publishes:
    move_base_simple/goal (geometry_msgs/PoseStamped): once, in the frame map

Parameters:
    ~x (float, 0 m): the goal
    ~y (float, 0 m): the goal
    ~yaw (float, 0 rad): the heading there
    ~time (float, 5.05 s, from 0): when to send it; later if move_base takes no goals yet
"""

import contextlib

import rospy
from geometry_msgs.msg import Point, Pose, PoseStamped, Quaternion
from odometry_common.node import run_node, spin
from odometry_common.parameters import Parameter, Parameters
from odometry_common.subscribing import Subscriber
from sim_turtlebot.geometry import about_z

PARAMETERS = Parameters(
    Parameter('~x', 0.0, 'the goal', 'm'),
    Parameter('~y', 0.0, 'the goal', 'm'),
    Parameter('~yaw', 0.0, 'the heading there', 'rad'),
    Parameter('~time', 5.05,
              'when to send it; later if move_base takes no goals yet', 's', 'from 0'))


def main():
    """Send the goal; it stays for a move_base that starts again."""
    goal = PARAMETERS.read()
    message = PoseStamped()
    message.header.frame_id = 'map'
    message.pose = Pose(Point(goal.x, goal.y, 0.0), Quaternion(*about_z(goal.yaw)))
    publisher = rospy.Publisher('move_base_simple/goal', PoseStamped, queue_size=1, latch=True)
    status = Subscriber('move_base/status', rospy.AnyMsg, lambda _: None, 'move_base')
    status.wait()  # an earlier goal would be lost
    due = rospy.Time.from_sec(goal.time)
    while rospy.Time.now() < due:
        with contextlib.suppress(rospy.exceptions.ROSTimeMovedBackwardsException):  # a reset
            rospy.sleep(due - rospy.Time.now())
    message.header.stamp = rospy.Time.now()
    publisher.publish(message)
    spin()


if __name__ == '__main__':
    run_node('send_goal', main, __doc__, PARAMETERS)
