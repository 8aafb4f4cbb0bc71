#!/usr/bin/env python3
"""Drive one metre ahead, and stop."""

import rospy
from nav_msgs.msg import Odometry
from odometry_common.velocity import VelocityPublisher

DISTANCE = 1.0  # m
SPEED = 0.2  # m/s


def main():
    """Answer each odometry message with a command."""
    rospy.init_node('one_metre')
    velocity = VelocityPublisher()  # whose last word is zero

    def on_odometry(message):
        velocity.publish(SPEED if message.pose.pose.position.x < DISTANCE else 0.0)

    rospy.Subscriber('odom', Odometry, on_odometry, tcp_nodelay=True)
    rospy.spin()


if __name__ == '__main__':
    main()
