#!/usr/bin/env python3
import rospy, math
from nav_msgs.msg import Odometry
from geometry_msgs.msg import Twist
from tf.transformations import euler_from_quaternion
yaw = 0
def get_rotation(msg):
    global yaw
    q = msg.pose.pose.orientation
    (roll, pitch, yaw) = euler_from_quaternion([q.x, q.y, q.z, q.w])
rospy.init_node('rotate_robot')
sub = rospy.Subscriber('/odom', Odometry, get_rotation)
pub = rospy.Publisher('cmd_vel', Twist, queue_size="1")
r = rospy.Rate(10)
command = Twist()
while not rospy.is_shutdown():
    command.angular.z = 0.5 * (math.radians(90) - yaw)
    pub.publish(command)
    r.sleep()
