#!/usr/bin/env python3
"""Publish world -> odom, so that RViz shows the true pose.

Subscribes:
    odom, base_pose_ground_truth (nav_msgs/Odometry): of the same robot
    initialpose (geometry_msgs/PoseWithCovarianceStamped): from RViz's 2D Pose Estimate

Publishes:
    /tf (tf2_msgs/TFMessage): world -> odom
    sim_turtlebot/set_pose (geometry_msgs/PoseStamped):
        each initialpose, which moves the robot there
"""

from geometry_msgs.msg import (
    PoseStamped,
    PoseWithCovarianceStamped,
    Quaternion,
    Transform,
    TransformStamped,
    Vector3,
)
from nav_msgs.msg import Odometry
from odometry_common.node import run_node, spin
from odometry_common.publishing import ClosingPublisher
from odometry_common.subscribing import Subscriber
from sim_turtlebot.frames import read_pose
from sim_turtlebot.geometry import compose, inverse, rotate
from tf2_msgs.msg import TFMessage


class WorldFrame:
    """Odometry and ground truth in, the transform between their frames out."""

    def __init__(self):
        self._odometry = None
        self._publisher = ClosingPublisher('/tf', TFMessage)
        self._set_pose = ClosingPublisher('sim_turtlebot/set_pose', PoseStamped)
        Subscriber('odom', Odometry, self._on_odometry, 'odometry')
        Subscriber('base_pose_ground_truth', Odometry, self._on_ground_truth, 'ground truth')
        Subscriber('initialpose', PoseWithCovarianceStamped, self._on_initial_pose)

    def _on_odometry(self, message):
        self._odometry = message

    def _on_ground_truth(self, ground_truth):
        if self._odometry is None:
            return
        place, orientation = read_pose(ground_truth.pose.pose)
        travelled, turned = read_pose(self._odometry.pose.pose)
        rotation = compose(orientation, inverse(turned))
        origin = [there - way for there, way in zip(place, rotate(rotation, travelled))]
        self._publisher.publish(TFMessage([TransformStamped(
            ground_truth.header, self._odometry.header.frame_id,
            Transform(Vector3(*origin), Quaternion(*rotation)))]))

    def _on_initial_pose(self, message):
        self._set_pose.publish(PoseStamped(message.header, message.pose.pose))


def main():
    """Publish until shutdown."""
    WorldFrame()
    spin()


if __name__ == '__main__':
    run_node('world_frame', main, __doc__)
