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

from functools import partial

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

ODOMETRY, GROUND_TRUTH = 'odom', 'base_pose_ground_truth'


class WorldFrame:
    """Odometry and ground truth in, the transform between their frames out."""

    def __init__(self):
        self._latest = {}  # Odometry by topic
        self._publisher = ClosingPublisher('/tf', TFMessage)
        self._set_pose = ClosingPublisher('sim_turtlebot/set_pose', PoseStamped)
        for topic in ODOMETRY, GROUND_TRUTH:
            Subscriber(topic, Odometry, partial(self._on_odometry, topic))
        Subscriber('initialpose', PoseWithCovarianceStamped, self._on_initial_pose)

    def _on_odometry(self, topic, message):
        self._latest[topic] = message
        odometry, ground_truth = map(self._latest.get, (ODOMETRY, GROUND_TRUTH))
        if odometry and ground_truth and odometry.header.stamp == ground_truth.header.stamp:
            self._publish(odometry, ground_truth)

    def _publish(self, odometry, ground_truth):
        place, orientation = read_pose(ground_truth.pose.pose)
        travelled, turned = read_pose(odometry.pose.pose)
        rotation = compose(orientation, inverse(turned))
        origin = [there - way for there, way in zip(place, rotate(rotation, travelled))]
        self._publisher.publish(TFMessage([TransformStamped(
            ground_truth.header, odometry.header.frame_id,
            Transform(Vector3(*origin), Quaternion(*rotation)))]))

    def _on_initial_pose(self, message):
        self._set_pose.publish(PoseStamped(message.header, message.pose.pose))


def main():
    """Publish until shutdown."""
    WorldFrame()
    spin()


if __name__ == '__main__':
    run_node('world_frame', main, __doc__)
