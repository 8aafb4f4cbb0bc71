#!/usr/bin/env python3
"""Drive ahead until something is closer than half a metre, and stop."""

import math

import rospy
from odometry_common.velocity import VelocityPublisher
from sensor_msgs.msg import LaserScan

CLEARANCE = 0.5  # m, from the depth camera
SPEED = 0.2  # m/s


def main():
    """Answer each scan with a command."""
    rospy.init_node('stop_before_wall')
    velocity = VelocityPublisher()  # its final message is zero

    def on_scan(scan):
        # +inf counts as far away, -inf as too close; ignore NaN.
        distances = (distance for distance in scan.ranges if not math.isnan(distance))
        nearest = min(distances, default=0.0)
        if nearest <= CLEARANCE:
            rospy.loginfo_throttle(10.0, f'stopping: something is {nearest:.2f} m ahead')
        velocity.publish(SPEED if nearest > CLEARANCE else 0.0)

    rospy.Subscriber('scan', LaserScan, on_scan, tcp_nodelay=True)
    rospy.spin()


if __name__ == '__main__':
    main()
