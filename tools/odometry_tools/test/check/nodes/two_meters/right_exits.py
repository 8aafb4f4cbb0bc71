#!/usr/bin/env python3
"""Adds up the steps itself, stops with a zero, and exits."""
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry

last = None
total = 0.0


def on_odom(msg):
    global last, total
    p = msg.pose.pose.position
    if last is not None:
        total += math.hypot(p.x - last.x, p.y - last.y)
    last = p


def main():
    rospy.init_node('drive', anonymous=True)
    pub = rospy.Publisher('/cmd_vel', Twist, queue_size=10)
    rospy.on_shutdown(lambda: pub.publish(Twist()))
    rospy.Subscriber('/odom', Odometry, on_odom)
    while pub.get_num_connections() == 0 and not rospy.is_shutdown():
        rospy.sleep(0.1)
    rate = rospy.Rate(20)
    cmd = Twist()
    cmd.linear.x = 0.2
    try:
        while total < 2.0:
            pub.publish(cmd)
            rate.sleep()
    except rospy.ROSInterruptException:
        pass
    pub.publish(Twist())
    rospy.rostime.wallsleep(0.2)


main()
