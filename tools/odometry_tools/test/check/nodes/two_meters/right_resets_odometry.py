#!/usr/bin/env python3
"""Sets odometry back to zero, waits for that, and drives in two pieces with a rest between them."""
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from std_msgs.msg import Empty

position = None


def on_odometry(message):
    global position
    position = message.pose.pose.position


def gone():
    return math.hypot(position.x, position.y)


rospy.init_node('two_pieces')
velocity = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rospy.on_shutdown(lambda: velocity.publish(Twist()))
reset = rospy.Publisher('mobile_base/commands/reset_odometry', Empty, queue_size=1)
rospy.Subscriber('odom', Odometry, on_odometry)
rate = rospy.Rate(20)
try:
    rospy.sleep(1)
    reset.publish()
    while position is None or gone() > 0.05:
        rate.sleep()
    forward = Twist()
    forward.linear.x = 0.2
    for goal in 1.0, 2.0:
        while gone() < goal:
            velocity.publish(forward)
            rate.sleep()
        velocity.publish(Twist())
        rospy.sleep(5)
except rospy.ROSInterruptException:
    pass
