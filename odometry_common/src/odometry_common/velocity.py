"""A velocity command publisher whose final message is zero."""

from geometry_msgs.msg import Twist

from odometry_common.publishing import ClosingPublisher


class VelocityPublisher(ClosingPublisher):
    """Publishes geometry_msgs/Twist, and a zero Twist as the final one at shutdown."""

    def __init__(self, topic='cmd_vel'):
        super().__init__(topic, Twist, final_message=Twist())

    def publish(self, linear=0.0, angular=0.0):
        """Command `linear` (m/s, forwards) and `angular` (rad/s, to the left); by default zero."""
        command = Twist()
        command.linear.x = linear
        command.angular.z = angular
        super().publish(command)
