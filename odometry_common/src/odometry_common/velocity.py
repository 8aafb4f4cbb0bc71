"""A velocity command publisher whose last word is zero."""

import math

from geometry_msgs.msg import Twist

from odometry_common.publishing import ClosingPublisher


class VelocityPublisher:
    """Publishes geometry_msgs/Twist, and a zero Twist as the very last one at shutdown."""

    def __init__(self, topic='cmd_vel', max_angular_speed=math.inf):
        """Advertise `topic`; clamp the angular velocity to `max_angular_speed` (rad/s)."""
        self._max_angular_speed = max_angular_speed
        self._publisher = ClosingPublisher(topic, Twist, last_word=Twist())

    def publish(self, linear=0.0, angular=0.0):
        """Command `linear` (m/s, forwards) and `angular` (rad/s, to the left)."""
        command = Twist()
        command.linear.x = linear
        command.angular.z = clamp(angular, self._max_angular_speed)
        self._publisher.publish(command)

    def stop(self):
        """Command zero."""
        self.publish()


def clamp(value, limit):
    """Return the number from -limit to limit that is nearest to the value."""
    return max(-limit, min(limit, value))
