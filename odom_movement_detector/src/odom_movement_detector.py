#!/usr/bin/env python3
"""Add up how far the robot has moved, and publish it.

Subscribes:
    odom (nav_msgs/Odometry): the robot's odometry
    moved_distance/reset (std_msgs/Empty): start counting from zero again

Publishes:
    moved_distance (std_msgs/Float64): metres travelled, once per odometry message

Parameters:
    ~min_step (float, 0.0 m, from 0): a displacement from the last counted position that is
        below this is not counted until it has grown
    ~max_speed (float, 5.0 m/s, from 0): a faster step is a jump of the odometry and is not
        counted, with one warning; 0 counts every step. Each step may take the usual time
        between messages, however their stamps are bunched
"""

import threading

import rospy
from moved_distance.distance_counter import DistanceCounter
from nav_msgs.msg import Odometry
from odometry_common.node import run_node
from odometry_common.parameters import get_number
from odometry_common.publishing import advertise
from std_msgs.msg import Empty, Float64

CLOSE_TIMEOUT = 0.5  # s, for a subscriber that has stopped reading


class MovementDetector:
    """The node: odometry in, moved distance out."""

    def __init__(self):
        """Read the parameters, then publish from the first odometry message on."""
        self._counter = DistanceCounter(
            min_step=get_number('~min_step', 0.0, lambda v: v >= 0, 'a number of metres from 0'),
            max_speed=get_number('~max_speed', 5.0, lambda v: v >= 0, 'a speed in m/s from 0'))
        self._lock = threading.Lock()
        self._wake_up = threading.Event()
        self._closed = False
        rospy.on_shutdown(self._close)
        # The publisher comes first: a callback may run as soon as its subscriber exists.
        self._publisher = advertise('moved_distance', Float64)
        rospy.Subscriber('odom', Odometry, self._on_odometry, tcp_nodelay=True)
        rospy.Subscriber('moved_distance/reset', Empty, self._on_reset)

    def wait_for_odometry(self):
        """Return when the first odometry has come, or at shutdown; say so each second."""
        while not (self._wake_up.wait(timeout=1.0) or rospy.is_shutdown()):
            rospy.loginfo('waiting for odometry on %s', rospy.resolve_name('odom'))

    def _on_odometry(self, message):
        position = message.pose.pose.position
        stamp = message.header.stamp.to_sec()
        try:
            with self._lock:
                if self._closed:
                    return
                jump = self._counter.add(position.x, position.y, stamp, rospy.get_time())
                self._publisher.publish(self._counter.distance)
        except ValueError as error:
            rospy.logwarn_throttle(1.0, f'odometry ignored: {error}')
            return
        if not self._wake_up.is_set():
            self._wake_up.set()
        if jump:
            rospy.logwarn_throttle(1.0, f'not counted: {jump}')

    def _on_reset(self, _message):
        with self._lock:
            self._counter.reset()
        rospy.loginfo('counting from zero again')

    def _close(self):
        """Publish nothing more: rospy closes the topics next."""
        # A subscriber that has stopped reading may hold the lock up.
        locked = self._lock.acquire(timeout=CLOSE_TIMEOUT)
        self._closed = True
        if locked:
            self._lock.release()
        self._wake_up.set()


def main():
    """Count until shutdown."""
    MovementDetector().wait_for_odometry()
    rospy.spin()


if __name__ == '__main__':
    run_node('movement_detector_node', main, __doc__, anonymous=True)
