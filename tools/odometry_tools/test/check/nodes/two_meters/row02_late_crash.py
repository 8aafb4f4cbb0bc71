#!/usr/bin/env python3
import rospy
from std_msgs.msg import Float64
from geometry_msgs.msg import Twist


class Mover(object):
    def __init__(self):
        self.moved = 0.0
        rospy.Subscriber('/moved_distance', Float64, self.cb)
        self.pub = rospy.Publisher('/cmd_vel', Twist, queue_size=1)

    def cb(self, msg):
        self.moved = msg.data

    def go(self):
        rate = rospy.Rate(10)
        cmd = Twist()
        while self.moved < 2.0:
            cmd.linear.x = 0.3
            self.pub.publish(cmd)
            rate.sleep()
        self.pub.publish(Stop())


rospy.init_node('mover')
Mover().go()
