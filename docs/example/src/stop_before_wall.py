#!/usr/bin/env python3
"""Drive ahead until something is nearer than half a metre, and stop."""

import math

import rospy
from geometry_msgs.msg import Twist
from sensor_msgs.msg import LaserScan

CLEARANCE = 0.5  # m, from the depth camera
SPEED = 0.2  # m/s


def main():
    """Answer each scan with a command."""
    rospy.init_node('stop_before_wall')
    velocity = rospy.Publisher('cmd_vel', Twist, queue_size=1)

    def on_scan(scan):
        # +inf is far away and -inf too close, as they should be; NaN says nothing.
        ranges = [distance for distance in scan.ranges if not math.isnan(distance)]
        command = Twist()
        if ranges and min(ranges) > CLEARANCE:
            command.linear.x = SPEED
        velocity.publish(command)

    scans = rospy.Subscriber('scan', LaserScan, on_scan, tcp_nodelay=True)

    def stop():
        scans.unregister()  # or a callback could have the last word
        velocity.publish(Twist())

    rospy.on_shutdown(stop)
    rospy.spin()


if __name__ == '__main__':
    main()
