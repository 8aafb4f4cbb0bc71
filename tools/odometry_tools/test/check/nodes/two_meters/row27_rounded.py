#!/usr/bin/env python3
import rospy
from geometry_msgs.msg import Twist
from std_msgs.msg import Float64


def cb(msg):
    t = Twist()
    if int(msg.data * 100) == 200:
        stopped.append(msg.data)
    if not stopped:
        t.linear.x = 0.45
    pub.publish(t)


stopped = []
rospy.init_node('rounded')
pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rospy.on_shutdown(lambda: pub.publish(Twist()))
rospy.Subscriber('moved_distance', Float64, cb)
rospy.spin()
