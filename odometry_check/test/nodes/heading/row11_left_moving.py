#!/usr/bin/env python3
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
import tf.transformations as tft

state = {'yaw': None}


def on_odom(msg):
    q = msg.pose.pose.orientation
    state['yaw'] = tft.euler_from_quaternion([q.x, q.y, q.z, q.w])[2]


if __name__ == '__main__':
    try:
        rospy.init_node('heading')
        pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
        rospy.Subscriber('odom', Odometry, on_odom)
        rate = rospy.Rate(15)
        while not rospy.is_shutdown():
            if state['yaw'] is not None:
                e = math.remainder(math.pi / 2 - state['yaw'], math.tau)
                t = Twist()
                t.angular.z = max(-0.6, min(0.6, 1.0 * e))
                pub.publish(t)
            rate.sleep()
    except rospy.ROSInterruptException:
        pass
