#!/usr/bin/env python3
"""Drive one metre ahead, and stop."""

import math

import rospy
from nav_msgs.msg import Odometry
from odometry_common.velocity import VelocityPublisher

DISTANCE = 1.0  # m


class OneMetre:
    """Looks at the odometry ten times a second, and commands the robot."""

    def __init__(self):
        """Publish and subscribe."""
        self.start = self.position = None  # no odometry has come
        self.distance = rospy.get_param('~distance', DISTANCE)  # m
        self.speed = rospy.get_param('~speed', 0.2)  # m/s
        self.velocity = VelocityPublisher()  # its last message is zero, however the node ends
        rospy.Subscriber('odom', Odometry, self.on_odometry)

    def on_odometry(self, message):
        """Keep the first position, and the latest."""
        position = message.pose.pose.position
        self.start = self.start or position  # run() needs both once there is a latest
        self.position = position

    def is_there(self):
        """Return whether the robot has moved far enough from where it started."""
        moved = math.hypot(self.position.x - self.start.x, self.position.y - self.start.y)
        return moved >= self.distance

    def run(self):
        """Drive until shutdown; stand while the position is unknown."""
        rate = rospy.Rate(10, reset=True)  # goes on after a reset of the simulation
        while not rospy.is_shutdown():
            drives = self.position and not self.is_there()
            self.velocity.publish(self.speed if drives else 0.0)
            rate.sleep()


if __name__ == '__main__':
    rospy.init_node('one_metre')
    try:
        OneMetre().run()
    except rospy.ROSInterruptException:  # shutdown
        pass
