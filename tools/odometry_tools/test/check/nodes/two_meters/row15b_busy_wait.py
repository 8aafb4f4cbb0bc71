#!/usr/bin/env python3
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry

begin = None
done = False


def callback(msg):
    global begin, done
    p = msg.pose.pose.position
    if begin is None:
        begin = p
    done = math.hypot(p.x - begin.x, p.y - begin.y) > 2


rospy.init_node('straight')
pub = rospy.Publisher('/cmd_vel', Twist, queue_size=1)
rospy.Subscriber('/odom', Odometry, callback)
rospy.sleep(1)
twist = Twist()
twist.linear.x = 0.2
pub.publish(twist)
while not done:
    pass
pub.publish(Twist())
