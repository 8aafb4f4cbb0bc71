#!/usr/bin/env python3
import rospy, math
from nav_msgs.msg import Odometry
from geometry_msgs.msg import Twist
import tf

yaw = 0.0

def newOdom(msg):
    global yaw
    q = msg.pose.pose.orientation
    yaw = tf.transformations.euler_from_quaternion([q.x, q.y, q.z, q.w])[2]

rospy.init_node("speed_controller")
rospy.Subscriber("/odom", Odometry, newOdom)
pub = rospy.Publisher("/cmd_vel", Twist, queue_size = 1)
r = rospy.Rate(4)
while not rospy.is_shutdown():
    speed = Twist()
    speed.angular.x = 0.5 * (math.pi / 2 - yaw)
    pub.publish(speed)
    r.sleep()
