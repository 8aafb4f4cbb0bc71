#!/usr/bin/env python3
"""Add up how far the robot has moved, and publish it.

Subscribes:
    odom (nav_msgs/Odometry): the robot's odometry
    moved_distance/reset (std_msgs/Empty): start counting from zero again

Publishes:
    moved_distance (std_msgs/Float64): metres travelled, once per odometry message

Parameters:
    ~min_step (float, 0 m, from 0): count the displacement from the last counted position once it
        reaches this
    ~max_speed (float, 5 m/s, from 0): warn of a faster step, a jump, and do not count it; 0 counts
        every step
"""

import rospy
from moved_distance.distance_counter import PARAMETERS, DistanceCounter
from nav_msgs.msg import Odometry
from odometry_common.node import run_node, spin
from odometry_common.publishing import ClosingPublisher
from odometry_common.subscribing import Subscriber
from std_msgs.msg import Empty, Float64


class MovementDetector:
    """The node: odometry in, moved distance out."""

    def __init__(self):
        parameters = PARAMETERS.read()
        self._counter = DistanceCounter(parameters.min_step, parameters.max_speed)
        self._publisher = ClosingPublisher('moved_distance', Float64)
        self._moved = Float64()
        self.odometry = Subscriber('odom', Odometry, self._on_odometry, 'odometry')
        Subscriber('moved_distance/reset', Empty, self._on_reset, queue_size=1)

    def _on_odometry(self, message):
        position, stamp = message.pose.pose.position, message.header.stamp
        jump = self._counter.add(position.x, position.y, stamp.to_sec(), rospy.get_time())
        self._moved.data = self._counter.distance
        self._publisher.publish(self._moved)
        if jump:
            rospy.logwarn_throttle(1.0, f'not counted: {jump}')

    def _on_reset(self, _message):
        self._counter.reset()
        rospy.loginfo_throttle(1.0, 'counting from zero again')


def main():
    """Count until shutdown."""
    if MovementDetector().odometry.wait():
        rospy.loginfo(f'counting from {rospy.resolve_name("odom")}')
    spin()


if __name__ == '__main__':
    run_node('movement_detector_node', main, __doc__, PARAMETERS, anonymous=True)
