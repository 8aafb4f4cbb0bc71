#!/usr/bin/env python3
"""Drive one metre ahead, and stop."""

import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry

DISTANCE = 1.0  # m


class OneMetre:
    """Looks at the odometry ten times a second, and commands the robot."""

    def __init__(self):
        """Publish and subscribe."""
        self.x = 0.0
        self.speed = rospy.get_param('~speed', 0.2)  # m/s
        self.publisher = rospy.Publisher('cmd_vel', Twist, queue_size=1)
        rospy.Subscriber('odom', Odometry, self.on_odometry)

    def on_odometry(self, message):
        """Keep the latest position."""
        self.x = message.pose.pose.position.x

    def run(self):
        """Drive until shutdown."""
        rate = rospy.Rate(10)
        while not rospy.is_shutdown():
            command = Twist()
            command.linear.x = self.speed if self.x < DISTANCE else 0.0
            self.publisher.publish(command)
            rate.sleep()


if __name__ == '__main__':
    rospy.init_node('one_metre')
    try:
        OneMetre().run()
    except rospy.ROSInterruptException:  # shutdown
        pass
