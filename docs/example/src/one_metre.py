#!/usr/bin/env python3
"""Drive one metre ahead, and stop."""

import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry

DISTANCE = 1.0  # m
SPEED = 0.2  # m/s


def main():
    """Answer each odometry message with a command."""
    rospy.init_node('one_metre')
    velocity = rospy.Publisher('cmd_vel', Twist, queue_size=1)

    def on_odometry(message):
        command = Twist()
        if message.pose.pose.position.x < DISTANCE:
            command.linear.x = SPEED
        velocity.publish(command)

    odometry = rospy.Subscriber('odom', Odometry, on_odometry, tcp_nodelay=True)

    def stop():
        odometry.unregister()  # or a callback could have the last word
        velocity.publish(Twist())

    rospy.on_shutdown(stop)
    rospy.spin()


if __name__ == '__main__':
    main()
