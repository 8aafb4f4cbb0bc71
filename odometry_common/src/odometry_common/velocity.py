"""A velocity command publisher whose last word is zero."""

import threading

import rospy
from geometry_msgs.msg import Twist

from odometry_common.publishing import advertise

CLOSE_TIMEOUT = 0.5  # s, for a subscriber that has stopped reading


class VelocityPublisher:
    """Publishes geometry_msgs/Twist, and a zero Twist as the very last one at shutdown.

    Messages are written to the subscribers before publish() returns: the final zero needs
    no sleep to get out, and no older command can follow it.
    """

    def __init__(self, topic='cmd_vel'):
        """Advertise `topic` and hook into rospy's shutdown."""
        self._publisher = advertise(topic, Twist)
        self._lock = threading.Lock()
        self._closed = False
        rospy.on_shutdown(self._close)

    def publish(self, linear=0.0, angular=0.0):
        """Command `linear` (m/s, forwards) and `angular` (rad/s, to the left)."""
        with self._lock:
            if not self._closed:
                self._write(linear, angular)

    def stop(self):
        """Command zero."""
        self.publish()

    def _close(self):
        if self._lock.acquire(timeout=CLOSE_TIMEOUT):
            self._closed = True
            self._write(0.0, 0.0)
            self._lock.release()

    def _write(self, linear, angular):
        command = Twist()
        command.linear.x = linear
        command.angular.z = angular
        self._publisher.publish(command)
