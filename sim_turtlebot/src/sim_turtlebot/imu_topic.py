"""The gyro of a robot as a topic, as kobuki_node publishes it."""

import sys

from odometry_common.geometry import about_z
from odometry_common.publishing import advertise
from sensor_msgs.msg import Imu

from sim_turtlebot.numbering import numbered, publish

# About x, y and z, of the orientation (rad^2) and of the angular velocity (rad^2/s^2), and the
# greatest number for what is not measured: kobuki_node/src/library/slot_callbacks.cpp.
VARIANCES = sys.float_info.max, sys.float_info.max, 0.005
NumberedImu = numbered(Imu)


class ImuTopic:
    """Publishes the heading and the yaw rate of a Robot's gyro, if anybody listens."""

    def __init__(self, robot, namespace):
        """Advertise; the parameters are those of RobotTopics."""
        self._robot = robot
        self._message = NumberedImu()
        self._message.header.frame_id = f'{namespace}gyro_link'
        self._message.orientation_covariance[::4] = VARIANCES
        self._message.angular_velocity_covariance[::4] = VARIANCES
        self._publisher = advertise(f'{namespace}mobile_base/sensors/imu_data', Imu)

    def publish(self, stamp, number):
        """Publish what the gyro senses.

        :param stamp: rospy.Time
        :param number: how many odometry periods have passed
        """
        if not self._publisher.get_num_connections():
            return
        gyro, orientation = self._robot.gyro, self._message.orientation
        orientation.x, orientation.y, orientation.z, orientation.w = about_z(gyro.heading)
        self._message.angular_velocity.z = gyro.rate
        publish(self._publisher, self._message, stamp, number)
