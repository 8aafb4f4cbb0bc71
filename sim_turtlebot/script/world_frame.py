#!/usr/bin/env python3
"""Publish where the odom frame is in the world, as a perfect localisation would.

RViz needs it to show the robot's odometry and its true pose in one picture.

Subscribes:
    odom, base_pose_ground_truth (nav_msgs/Odometry): of the same robot

Publishes:
    /tf (tf2_msgs/TFMessage): world -> odom
"""

import rospy
import tf
from nav_msgs.msg import Odometry
from odometry_common.node import run_node
from tf.transformations import (
    concatenate_matrices,
    inverse_matrix,
    quaternion_from_matrix,
    quaternion_matrix,
    translation_from_matrix,
    translation_matrix,
)


class WorldFrame:
    """Odometry and ground truth in, the transform between their frames out."""

    def __init__(self):
        """Publish with each true pose from the first odometry on."""
        self._odometry = None
        self._stopping = False
        rospy.on_shutdown(self._stop)
        self._broadcaster = tf.TransformBroadcaster()
        rospy.Subscriber('odom', Odometry, self._on_odometry, tcp_nodelay=True)
        rospy.Subscriber(
            'base_pose_ground_truth', Odometry, self._on_ground_truth, tcp_nodelay=True)

    def _on_odometry(self, message):
        self._odometry = message

    def _on_ground_truth(self, ground_truth):
        if self._odometry is None:
            return
        try:
            self._publish(ground_truth)
        except rospy.ROSException:
            # At shutdown rospy may close the topic while messages still come.
            if not self._stopping:
                raise

    def _publish(self, ground_truth):
        frame = concatenate_matrices(_matrix(ground_truth), inverse_matrix(_matrix(self._odometry)))
        self._broadcaster.sendTransform(
            translation_from_matrix(frame), quaternion_from_matrix(frame), ground_truth.header.stamp,
            self._odometry.header.frame_id, ground_truth.header.frame_id)

    def _stop(self):
        self._stopping = True


def _matrix(message):
    position, orientation = message.pose.pose.position, message.pose.pose.orientation
    return concatenate_matrices(
        translation_matrix([position.x, position.y, position.z]),
        quaternion_matrix([orientation.x, orientation.y, orientation.z, orientation.w]))


def main():
    """Publish until shutdown."""
    WorldFrame()
    rospy.spin()


if __name__ == '__main__':
    run_node('world_frame', main, __doc__)
