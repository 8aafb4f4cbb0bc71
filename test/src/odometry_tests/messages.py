"""Messages that tests send."""

import math

import rospy
from nav_msgs.msg import Odometry

STRANGE = [math.nan, math.inf, -math.inf, 1e308, -1e308, 5e-324, -0.0]


def odometry(x=0.0, y=0.0, yaw=0.0, stamp=0.0):
    """Return an Odometry at x, y (m) and yaw (rad), measured at stamp (s)."""
    message = Odometry(child_frame_id='base_footprint')
    message.header.frame_id = 'odom'
    message.header.stamp = rospy.Time.from_sec(stamp)
    message.pose.pose.position.x = x
    message.pose.pose.position.y = y
    message.pose.pose.orientation.z = math.sin(yaw / 2)
    message.pose.pose.orientation.w = math.cos(yaw / 2)
    return message
