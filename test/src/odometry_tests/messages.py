"""Messages that tests send."""

import math

import rospy
from geometry_msgs.msg import Quaternion
from nav_msgs.msg import Odometry
from sim_turtlebot.geometry import about_z

STRANGE = [math.nan, math.inf, -math.inf, 1e308, -1e308, 5e-324, -0.0]
STRANGE_QUATERNIONS = [(0, 0, 0, 0), (0, 0, 0, 1e-320), (0, 0, 3, 4), (1e200, 0, 0, 1e200),
                       *((value, 0, 0, 1) for value in STRANGE)]
STRANGE_STAMPS = [0.0, 5.0, 5.0, 4.0, 3605.0, 5.0]  # s


def odometry(x=0.0, y=0.0, yaw=0.0, stamp=0.0):
    """Return an Odometry at x, y (m) and yaw (rad), measured at stamp (s)."""
    message = Odometry(child_frame_id='base_footprint')
    message.header.frame_id = 'odom'
    message.header.stamp = rospy.Time.from_sec(stamp)
    message.pose.pose.position.x = x
    message.pose.pose.position.y = y
    message.pose.pose.orientation = Quaternion(*about_z(yaw))
    return message


def strange_odometry():
    """Return an Odometry with each strange number in each place, and strange stamps and frames."""
    messages = [odometry(stamp=stamp) for stamp in STRANGE_STAMPS]
    messages += [odometry(x=value) for value in STRANGE] + [odometry(y=value) for value in STRANGE]
    for numbers in STRANGE_QUATERNIONS:
        message = odometry()
        message.pose.pose.orientation = Quaternion(*numbers)
        messages.append(message)
    messages.append(Odometry())  # empty frames, no length of the quaternion, no stamp
    return messages


def stamp(message):
    """Return the time (s) in the header of a message, or of a TFMessage's first transform."""
    header = message.transforms[0].header if hasattr(message, 'transforms') else message.header
    return header.stamp.to_sec()
