"""The topics that a robot publishes."""

import sys

from geometry_msgs.msg import Point, Pose, Quaternion, Twist, Vector3
from nav_msgs.msg import Odometry
from odometry_common.publishing import advertise
from sensor_msgs.msg import Imu, JointState, LaserScan

from sim_turtlebot.frames import Frames
from sim_turtlebot.geometry import about_z
from sim_turtlebot.kobuki import DEPTH_CAMERA_FRAME
from sim_turtlebot.physics.description import WHEEL_JOINTS

# About x, y and z, of the IMU's orientation (rad^2) and angular velocity (rad^2/s^2); the largest
# float where a Kobuki measures nothing: kobuki_node/src/library/slot_callbacks.cpp.
IMU_VARIANCES = sys.float_info.max, sys.float_info.max, 0.005
NOT_MEASURED = -1  # the first element of a covariance, as sensor_msgs/Imu defines it


class Topic:
    """A topic whose header.seq is the number of the odometry period.

    rospy would count the messages that it sends. With our number, a message that is sent twice
    stays the same, and two runs give the same bytes.
    """

    def __init__(self, name, message_class, frame, /, **fields):
        """Advertise; fill `message` before publish()."""
        # Without _has_header rospy does not set header.seq.
        numbered = type(
            f'Numbered{message_class.__name__}', (message_class,), {'_has_header': False})
        self.message = numbered(**fields)
        self.message.header.frame_id = frame
        self._publisher = advertise(name, message_class)

    @property
    def has_subscribers(self):
        """Whether anyone subscribes."""
        return self._publisher.get_num_connections() > 0

    def publish(self, stamp, number):
        """Publish the message.

        :param stamp: rospy.Time
        :param number: how many odometry periods have passed
        """
        self.message.header.stamp = stamp
        self.message.header.seq = number
        self._publisher.publish(self.message)


class RobotTopics:
    """Publishes the state of a Robot; skips topics without subscribers."""

    def __init__(self, robot, settings):
        """Advertise.

        :param robot: sim_turtlebot.robot.robot.Robot; topics and frames begin with its namespace
        :param settings: of sim_turtlebot.settings.read_settings()
        """
        self._robot, namespace = robot, robot.namespace
        self.frames = Frames(robot, settings.publish_tf)
        base = f'{namespace}base_footprint'
        self._odometry = Topic(f'{namespace}odom', Odometry, f'{namespace}odom',
                               child_frame_id=base)
        self._odometry.message.pose.covariance[::7] = robot.estimator.covariance
        self._odometry.message.twist.covariance[::7] = robot.estimator.twist_covariance
        self._ground_truth = Topic(f'{namespace}base_pose_ground_truth', Odometry, 'world',
                                   child_frame_id=base)
        self._joints = Topic(f'{namespace}joint_states', JointState, '', name=WHEEL_JOINTS)
        self._imu = Topic(f'{namespace}mobile_base/sensors/imu_data', Imu, f'{namespace}gyro_link')
        self._imu.message.orientation_covariance[::4] = IMU_VARIANCES
        self._imu.message.angular_velocity_covariance[::4] = IMU_VARIANCES
        self._imu.message.linear_acceleration_covariance[0] = NOT_MEASURED
        if robot.scanner:
            self._scan = Topic(
                f'{namespace}scan', LaserScan, f'{namespace}{DEPTH_CAMERA_FRAME}',
                angle_min=-settings.scan_fov / 2, angle_max=settings.scan_fov / 2,
                angle_increment=settings.scan_fov / (settings.scan_beams - 1),
                scan_time=1 / settings.scan_rate,
                range_min=settings.scan_range_min, range_max=settings.scan_range_max)

    def publish(self, stamp, number):
        """Publish all but the scan; parameters as for Topic.publish()."""
        robot = self._robot
        for topic, motion in ((self._odometry, robot.odometry),
                              (self._ground_truth, robot.ground_truth)):
            if topic.has_subscribers:
                topic.message.pose.pose = Pose(
                    Point(*motion.position), Quaternion(*motion.orientation))
                topic.message.twist.twist = Twist(
                    Vector3(*motion.linear), Vector3(*motion.angular))
                topic.publish(stamp, number)
        # Reading the wheels takes as long as a physics step.
        if self._joints.has_subscribers:
            joints = self._joints.message
            joints.position, joints.velocity, joints.effort = robot.wheels
            self._joints.publish(stamp, number)
        if self._imu.has_subscribers:
            imu = self._imu.message
            imu.orientation = Quaternion(*about_z(robot.gyro.heading))
            imu.angular_velocity.z = robot.gyro.rate
            self._imu.publish(stamp, number)

    def publish_scan(self, stamp, number):
        """Publish a scan if one is due, with the odometry of the same moment."""
        scanner = self._robot.scanner
        # Casting the rays costs more than everything else in an odometry period.
        if scanner and self._scan.has_subscribers and scanner.is_due(number):
            self._scan.message.ranges = scanner.scan(number).tolist()
            self._scan.publish(stamp, number)
