"""Whoever puts a simulated robot somewhere."""

import math

import rospy
from geometry_msgs.msg import Point, Pose, PoseStamped, Quaternion

from odometry_tests.waiting import wait_for_subscribers

ON_ITS_SIDE = Quaternion(math.sqrt(0.5), 0.0, 0.0, math.sqrt(0.5))


class Placer:
    """Puts one robot somewhere."""

    def __init__(self, namespace='/', robot=''):
        """Return once the simulator listens.

        :param namespace: of the simulator; it ends in a slash
        :param robot: of the robot, if there are several; it ends in a slash
        """
        self._publisher = rospy.Publisher(f'{namespace}sim_turtlebot/{robot}set_pose', PoseStamped,
                                          queue_size=10)
        wait_for_subscribers(self._publisher)

    def put(self, x, y, z=0.0, yaw=0.0, orientation=None, frame='world'):
        """Put it there; m, rad, or an orientation instead of the yaw."""
        self._publisher.publish(pose(x, y, z, yaw, orientation, frame))


def pose(x, y, z=0.0, yaw=0.0, orientation=None, frame='world'):
    """Return a PoseStamped; m, rad, or an orientation instead of the yaw."""
    message = PoseStamped(pose=Pose(Point(x, y, z), orientation or quaternion(yaw)))
    message.header.frame_id = frame
    return message


def quaternion(yaw):
    """Return the orientation with a yaw (rad)."""
    return Quaternion(0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2))
