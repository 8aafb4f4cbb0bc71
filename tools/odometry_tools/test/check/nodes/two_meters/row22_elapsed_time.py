#!/usr/bin/env python3
import rospy
from geometry_msgs.msg import Twist

SPEED = 0.2
DISTANCE = 2.0

rospy.init_node('move_two_meters')
pub = rospy.Publisher('/cmd_vel', Twist, queue_size=10)
while rospy.Time.now().to_sec() == 0:
    rospy.rostime.wallsleep(0.01)
rospy.sleep(0.5)
t0 = rospy.Time.now().to_sec()
current_distance = 0
rate = rospy.Rate(20)
vel = Twist()
try:
    while current_distance < DISTANCE:
        vel.linear.x = SPEED
        pub.publish(vel)
        t1 = rospy.Time.now().to_sec()
        current_distance = SPEED * (t1 - t0)
        rate.sleep()
finally:
    pub.publish(Twist())
rospy.spin()
