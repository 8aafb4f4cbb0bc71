#!/usr/bin/env python3
import rospy, numpy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from tf.transformations import quaternion_matrix, euler_matrix

pose = numpy.identity(4)

def cb(m):
    global pose
    o = m.pose.pose.orientation
    pose = quaternion_matrix([o.x, o.y, o.z, o.w])

rospy.init_node('matrix_rotate')
rospy.Subscriber('odom', Odometry, cb)
pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rospy.on_shutdown(lambda: pub.publish(Twist()))
goal = euler_matrix(0, 0, numpy.pi / 2)
rospy.wait_for_message('odom', Odometry)
rate = rospy.Rate(10)
while not rospy.is_shutdown():
    cmd = Twist()
    if not numpy.allclose(pose, goal, atol=0.2):
        delta = numpy.dot(numpy.linalg.inv(pose), goal)
        cmd.angular.z = 0.4 if delta[1, 0] > 0 else -0.4
    pub.publish(cmd)
    rate.sleep()
