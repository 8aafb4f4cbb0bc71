#!/usr/bin/env python3
"""Drive one metre ahead, and stop."""

import math

import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry

DISTANCE = 1.0  # m


class OneMetre:
    """Looks at the odometry ten times a second, and commands the robot."""

    def __init__(self):
        """Publish and subscribe."""
        self.start = self.position = None  # no odometry has come
        self.distance = rospy.get_param('~distance', DISTANCE)  # m
        self.speed = rospy.get_param('~speed', 0.2)  # m/s
        self.publisher = rospy.Publisher('cmd_vel', Twist, queue_size=1)
        rospy.on_shutdown(self.stop)
        rospy.Subscriber('odom', Odometry, self.on_odometry)

    def on_odometry(self, message):
        """Keep the latest position, and the first."""
        self.position = message.pose.pose.position
        self.start = self.start or self.position

    def is_there(self):
        """Return whether the robot has moved far enough from where it started."""
        moved = math.hypot(self.position.x - self.start.x, self.position.y - self.start.y)
        return moved >= self.distance

    def run(self):
        """Drive until shutdown; stand while the position is unknown."""
        rate = rospy.Rate(10)
        while not rospy.is_shutdown():
            command = Twist()
            if self.position and not self.is_there():
                command.linear.x = self.speed
            self.publisher.publish(command)
            rate.sleep()

    def stop(self):
        """Leave no speed set, however the node ends."""
        self.publisher.publish(Twist())


if __name__ == '__main__':
    rospy.init_node('one_metre')
    try:
        OneMetre().run()
    except rospy.ROSInterruptException:  # shutdown
        pass
