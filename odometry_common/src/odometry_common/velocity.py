"""A velocity command publisher whose final message is zero."""

from geometry_msgs.msg import Twist

from odometry_common.publishing import ClosingPublisher


class VelocityPublisher:
    """Publishes geometry_msgs/Twist, and a zero Twist as the final one at shutdown."""

    def __init__(self, topic='cmd_vel'):
        """Advertise `topic`."""
        self._publisher = ClosingPublisher(topic, Twist, final_message=Twist())

    def get_num_connections(self):
        """Return how many subscribers are connected, as a rospy.Publisher does."""
        return self._publisher.get_num_connections()

    def publish(self, linear=0.0, angular=0.0):
        """Command `linear` (m/s, forwards) and `angular` (rad/s, to the left)."""
        command = Twist()
        command.linear.x = linear
        command.angular.z = angular
        self._publisher.publish(command)

    def stop(self):
        """Command zero."""
        self.publish()
