"""Commands to robots, and their poses."""

from geometry_msgs.msg import Point, Pose, PoseStamped, Quaternion, Twist, Vector3
from odometry_common.orientation import yaw_from_orientation
from sim_turtlebot.geometry import about_z


def twist(forwards, left=0.0):
    return Twist(Vector3(x=forwards), Vector3(z=left))


def place(message):
    """Return x, y (m) and yaw (rad) of an Odometry, rounded to a hundredth."""
    position = message.pose.pose.position
    return tuple(round(number, 2) + 0.0 for number in
                 (position.x, position.y, yaw_from_orientation(message.pose.pose.orientation)))


def pose(x, y, z=0.0, yaw=0.0, orientation=None, frame='world'):
    """Return a PoseStamped; m, rad, or an orientation instead of the yaw."""
    message = PoseStamped(pose=Pose(Point(x, y, z), orientation or Quaternion(*about_z(yaw))))
    message.header.frame_id = frame
    return message
