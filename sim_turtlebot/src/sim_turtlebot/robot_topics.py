"""The topics of one robot."""

from functools import partial

import rospy
from geometry_msgs.msg import PoseStamped, TransformStamped, Twist
from nav_msgs.msg import Odometry
from odometry_common.publishing import advertise
from sensor_msgs.msg import JointState
from std_msgs.msg import Empty

from sim_turtlebot.imu_topic import ImuTopic
from sim_turtlebot.link_frames import LinkFrames
from sim_turtlebot.numbering import numbered, publish
from sim_turtlebot.velocity_mux import INPUTS

WHEEL_JOINTS = ['wheel_left_joint', 'wheel_right_joint']
NumberedOdometry, NumberedJointState = numbered(Odometry), numbered(JointState)


class RobotTopics:
    """Publishes the state of a Robot, and passes commands on."""

    def __init__(self, robot, namespace):
        """Advertise.

        :param robot: sim_turtlebot.robot.Robot
        :param namespace: '' or one that ends in a slash; topics and frames begin with it
        """
        self._robot = robot
        self._namespace = namespace
        self._odometry = _new_odometry(f'{namespace}odom', f'{namespace}base_footprint')
        self._odometry.pose.covariance = _diagonal(robot.covariance)
        self._ground_truth = _new_odometry('world', f'{namespace}base_footprint')
        self._joints = NumberedJointState(name=WHEEL_JOINTS)
        self._transform = TransformStamped(child_frame_id=self._odometry.child_frame_id)
        self._transform.header.frame_id = self._odometry.header.frame_id
        self._links = LinkFrames(namespace)
        self._publishers = [
            (self._odometry, advertise(f'{namespace}odom', Odometry)),
            (self._ground_truth, advertise(f'{namespace}base_pose_ground_truth', Odometry))]
        self._joint_publisher = advertise(f'{namespace}joint_states', JointState)
        self._imu = ImuTopic(robot, namespace)

    def subscribe(self, on_velocity, on_reset_odometry, on_set_pose):
        """Listen for commands.

        The first argument of each function is the message's sender, see sender_of().

        :param on_velocity: function of linear (m/s) and angular (rad/s) velocity, and of the input
            of the multiplexer that they came through; None if they bypass it
        :param on_reset_odometry: function without more arguments
        :param on_set_pose: function of a frame_id, a position and an orientation, as tuples
        """
        def on_twist(mux_input, message):
            on_velocity(sender_of(message), message.linear.x, message.angular.z, mux_input)

        def on_pose(message):
            position, orientation = message.pose.position, message.pose.orientation
            on_set_pose(sender_of(message), message.header.frame_id, (position.x, position.y, position.z),
                        (orientation.x, orientation.y, orientation.z, orientation.w))

        inputs = {'cmd_vel': None, 'mobile_base/commands/velocity': None,
                  **{name: name for name in INPUTS}}
        for topic, mux_input in inputs.items():
            rospy.Subscriber(f'{self._namespace}{topic}', Twist, partial(on_twist, mux_input),
                             tcp_nodelay=True)
        rospy.Subscriber(f'{self._namespace}mobile_base/commands/reset_odometry', Empty,
                         lambda message: on_reset_odometry(sender_of(message)))
        rospy.Subscriber(f'~{self._namespace}set_pose', PoseStamped, on_pose, tcp_nodelay=True)

    def publish(self, stamp, number):
        """Publish the robot's state, as far as anybody listens.

        :param stamp: rospy.Time
        :param number: how many odometry periods have passed
        """
        motions = self._robot.odometry, self._robot.ground_truth
        for motion, (message, publisher) in zip(motions, self._publishers):
            if publisher.get_num_connections():
                _fill(message, motion)
                publish(publisher, message, stamp, number)
        # To ask for the wheels costs as much as a physics step.
        if self._joint_publisher.get_num_connections():
            joints = self._joints
            joints.position, joints.velocity, joints.effort = self._robot.wheels
            publish(self._joint_publisher, joints, stamp, number)
        self._imu.publish(stamp, number)

    def fixed_frames(self, stamp):
        """Return the transforms from base_footprint to all links but the wheels."""
        return self._links.fixed(stamp)

    def base_frame(self, stamp):
        """Return the transform from odom to base_footprint."""
        transform = self._transform.transform
        self._transform.header.stamp = stamp
        _fill_pose(transform.translation, transform.rotation, self._robot.odometry)
        return self._transform

    def wheel_frames(self, stamp):
        """Return the transforms from base_link to the wheels."""
        return self._links.moving(stamp, dict(zip(WHEEL_JOINTS, self._robot.wheels[0])))


def sender_of(message):
    """Return the names of the node that has sent a message or a request, and of its topic or service."""
    header = message._connection_header
    return header['callerid'], header.get('topic') or header.get('service', '')


def _new_odometry(frame, child_frame):
    message = NumberedOdometry(child_frame_id=child_frame)
    message.header.frame_id = frame
    return message


def _diagonal(variances):
    matrix = [0.0] * len(variances)**2
    matrix[::len(variances) + 1] = variances
    return matrix


def _fill(message, motion):
    pose, twist = message.pose.pose, message.twist.twist
    _fill_pose(pose.position, pose.orientation, motion)
    twist.linear.x, twist.linear.y, twist.linear.z = motion.linear
    twist.angular.x, twist.angular.y, twist.angular.z = motion.angular


def _fill_pose(position, orientation, motion):
    position.x, position.y, position.z = motion.position
    orientation.x, orientation.y, orientation.z, orientation.w = motion.orientation
