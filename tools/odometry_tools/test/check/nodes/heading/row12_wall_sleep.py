#!/usr/bin/env python3
import math
import time
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from tf.transformations import euler_from_quaternion

heading = None


def on_odometry(msg):
    global heading
    q = msg.pose.pose.orientation
    _, _, heading = euler_from_quaternion([q.x, q.y, q.z, q.w])


rospy.init_node('turn_to_heading')
pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rospy.on_shutdown(lambda: pub.publish(Twist()))
rospy.Subscriber('odom', Odometry, on_odometry)
while not rospy.is_shutdown():
    if heading is not None:
        error = (math.pi / 2 - heading + math.pi) % (2 * math.pi) - math.pi
        cmd = Twist()
        cmd.angular.z = 0.5 * error
        pub.publish(cmd)
    time.sleep(0.1)
