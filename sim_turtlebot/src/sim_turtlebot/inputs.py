"""The simulator's inputs: each message or service call becomes a request to its main thread."""

from functools import partial

import rospy
from geometry_msgs.msg import PoseStamped, Twist
from odometry_common.parameters import ParameterError
from std_msgs.msg import Empty
from std_srvs import srv

from sim_turtlebot.frames import read_pose
from sim_turtlebot.robot.multiplexer import INPUTS
from sim_turtlebot.robot.poses import checked_pose


class Inputs:
    """Turns messages and calls into requests for robots."""

    def __init__(self, robots, requests, warn):
        """Subscribe.

        :param requests: sim_turtlebot.requests.RequestQueue
        :param warn: called with a topic and why a pose on it is refused, or '' if it is accepted
        """
        self._requests, self._warn = requests, warn
        self.obeys = True  # lockstep ignores commands before time zero
        self.pose_is_set = False  # since the robots were published
        for robot in robots:
            for topic in ('cmd_vel', 'mobile_base/commands/velocity', *INPUTS):
                self._subscribe(f'{robot.namespace}{topic}', Twist, self._command, robot, topic)
            self._subscribe(f'{robot.namespace}mobile_base/commands/reset_odometry', Empty,
                            lambda _, robot: robot.reset_odometry(), robot)
            self._subscribe(f'~{robot.namespace}set_pose', PoseStamped, self._set_pose, robot)

    def serve(self, name, action, kind=srv.Empty, prepare=tuple):
        """Offer a service: the main thread calls `action`, which returns the response's fields.

        :param prepare: returns the arguments of the action; called on rospy's thread, since it may
            ask the master
        """
        rospy.Service(name, kind, partial(self._answer, action, prepare))

    def _subscribe(self, topic, message_class, action, *arguments):
        """Have the main thread call action(message, *arguments) for each message."""
        # Of messages that arrive together rospy reads only the latest, so a flood costs little.
        rospy.Subscriber(
            topic, message_class,
            lambda message: self._requests.put(
                *_sender_of(message), partial(action, message, *arguments)),
            queue_size=1, tcp_nodelay=True)

    def _answer(self, action, prepare, request):
        try:
            fields = self._requests.call(*_sender_of(request), partial(action, *prepare()))
        except (OSError, ParameterError) as error:
            raise rospy.ServiceException(error) from None
        return fields or []

    def _command(self, twist, robot, topic):
        if not self.obeys:
            # Whether a command arrives so early depends on connection timing.
            rospy.logwarn_once(
                'lockstep ignores commands before time zero: wait for the first /odom')
            return
        try:
            robot.command(twist.linear.x, twist.angular.z, topic)
        except ValueError as error:
            rospy.logwarn_throttle(1.0, f'stopping: {error}')

    def _set_pose(self, message, robot):
        topic, refusal = f'~{robot.namespace}set_pose', ''
        try:
            robot.set_pose(*checked_pose(message.header.frame_id, *read_pose(message.pose)))
            self.pose_is_set = True
        except ValueError as error:
            refusal = f'{topic} refused: {error}'
            rospy.logwarn_throttle(1.0, refusal)
        self._warn(topic, refusal)  # RViz and the page do not show the log


def _sender_of(message):
    """Return the names of the node that sent a message or request, and of the topic or service.

    rospy accepts a publisher that does not give its name.
    """
    header = message._connection_header
    return header.get('callerid', ''), header.get('topic') or header.get('service', '')
