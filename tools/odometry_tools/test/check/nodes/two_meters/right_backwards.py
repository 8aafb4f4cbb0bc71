#!/usr/bin/env python3
import rospy
from geometry_msgs.msg import Twist, Vector3
from std_msgs.msg import Float64


class Mover(object):
    def __init__(self):
        self.moved = None
        self.velocity = rospy.Publisher('mobile_base/commands/velocity', Twist, queue_size=1)
        rospy.Subscriber('moved_distance', Float64, self.on_moved)
        rospy.on_shutdown(lambda: self.velocity.publish(Twist()))
        self.timer = rospy.Timer(rospy.Duration(0.05), self.tick)

    def on_moved(self, message):
        self.moved = message.data

    def tick(self, _event):
        if self.moved is not None:
            self.velocity.publish(Twist(linear=Vector3(-0.25 if self.moved < 2 else 0, 0, 0)))


if __name__ == '__main__':
    rospy.init_node('reverse')
    Mover()
    rospy.spin()
