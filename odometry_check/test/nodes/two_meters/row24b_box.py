#!/usr/bin/env python3
import rospy
from nav_msgs.msg import Odometry
from geometry_msgs.msg import Twist


class Box:
    def __init__(self):
        self.start = None
        self.pos = None
        self.pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
        self.sub = rospy.Subscriber('odom', Odometry, self.odom)
        rospy.on_shutdown(lambda: self.pub.publish(Twist()))

    def odom(self, m):
        self.pos = m.pose.pose.position
        self.start = self.start or self.pos

    def run(self):
        rate = rospy.Rate(10)
        while not rospy.is_shutdown():
            t = Twist()
            if self.pos and abs(self.pos.x - self.start.x) < 2 and abs(self.pos.y - self.start.y) < 2:
                t.linear.x = 0.25
            self.pub.publish(t)
            rate.sleep()


rospy.init_node('box')
Box().run()
