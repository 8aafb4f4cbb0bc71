#!/usr/bin/env python3
"""Print the robot's yaw in radians and, once a second, its orientation as a quaternion [x y z w].

Subscribes:
    odom (nav_msgs/Odometry): the robot's odometry
"""

import rospy
from nav_msgs.msg import Odometry
from odometry_common.node import run_node
from odometry_common.orientation import euler_from_orientation
from odometry_common.subscribing import Subscriber
from tf.transformations import quaternion_from_euler


class HeadingPrinter:
    """The node: odometry in, headings on the screen."""

    def __init__(self):
        self._euler = None
        Subscriber('odom', Odometry, self._on_odometry, 'odometry')

    def print_quaternions(self):
        """Print a quaternion each second until shutdown, from the first message on."""
        rate = rospy.Rate(1, reset=True)
        while not rospy.is_shutdown():
            if self._euler is not None:
                print(quaternion_from_euler(*self._euler))
            rate.sleep()

    def _on_odometry(self, message):
        self._euler = euler_from_orientation(message.pose.pose.orientation)
        print(self._euler[2])


def main():
    """Print until shutdown."""
    HeadingPrinter().print_quaternions()


if __name__ == '__main__':
    run_node('my_quaternion_to_euler', main, __doc__)
