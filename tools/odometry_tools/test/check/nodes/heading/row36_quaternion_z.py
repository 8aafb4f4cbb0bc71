#!/usr/bin/env python3
import rospy, math
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry

theta = 0.0

def callback(msg):
    global theta
    theta = msg.pose.pose.orientation.z

def main():
    rospy.init_node('rotate')
    rospy.Subscriber('/odom', Odometry, callback)
    pub = rospy.Publisher('/cmd_vel', Twist, queue_size=1)
    rate = rospy.Rate(10)
    while not rospy.is_shutdown():
        vel = Twist()
        vel.angular.z = 0.5 * (math.radians(90) - theta)
        pub.publish(vel)
        rate.sleep()

main()
