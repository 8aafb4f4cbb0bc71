#!/usr/bin/env python3
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from tf.transformations import euler_from_quaternion


def yaw_of(msg):
    q = msg.pose.pose.orientation
    return euler_from_quaternion([q.x, q.y, q.z, q.w])[2]


def main():
    rospy.init_node('rotate_90')
    pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
    rospy.on_shutdown(lambda: pub.publish(Twist()))
    start = yaw_of(rospy.wait_for_message('odom', Odometry))
    rate = rospy.Rate(10)
    turned = 0.0
    while abs(turned - math.pi / 2) > 0.01 and not rospy.is_shutdown():
        now = yaw_of(rospy.wait_for_message('odom', Odometry))
        turned = math.atan2(math.sin(now - start), math.cos(now - start))
        cmd = Twist()
        cmd.angular.z = 0.8 * (math.pi / 2 - turned)
        pub.publish(cmd)
        rate.sleep()
    pub.publish(Twist())
    rospy.sleep(0.5)


main()
