#!/usr/bin/env python3
"""Turn the robot to a target heading with a P-controller.

Subscribes:
    odom (nav_msgs/Odometry): the robot's odometry
    ~target (std_msgs/Float64): a new target heading in degrees

Publishes:
    cmd_vel (geometry_msgs/Twist): angular.z = kp * (target - yaw), the shorter way round

Parameters:
    ~target (float, 90 degrees): heading to turn to, in the odom frame
    ~kp (float, 0.5 1/s, above 0): gain
    ~rate (float, 10 Hz, from 0.1 to 1000): control rate
    ~max_angular_speed (float, 3.14 rad/s, above 0): the command is clamped to this
    ~tolerance (float, 0 degrees, from 0 to below 180): exit once the robot is at rest this close to
        the target; 0: never
    ~timeout (float, 1 s, from 0 to 3600): stop and warn while no odometry arrives for this long
        (ROS time, and at least 0.2 s of wall time); 0: never

The node always sends zero before it exits.
"""

import math

import rospy
from heading_control.turn import PARAMETERS, Turn
from nav_msgs.msg import Odometry
from odometry_common.node import run_node
from odometry_common.orientation import yaw_from_orientation
from odometry_common.publisher_conflicts import warn_of_conflicts
from odometry_common.rest import ANGLE_BAND, RestDetector
from odometry_common.subscribing import Subscriber, callback_lock
from odometry_common.velocity import VelocityPublisher
from odometry_common.watchdog import Watchdog
from std_msgs.msg import Float64


class RotateRobot:
    """The node: heading in, angular velocity out."""

    def __init__(self):
        parameters = PARAMETERS.read()
        self._turn = Turn(parameters.target, parameters.kp, parameters.max_angular_speed)
        self._hertz = parameters.rate
        self._tolerance = math.radians(parameters.tolerance)
        self._watchdog = Watchdog(parameters.timeout)
        self._rest = RestDetector(ANGLE_BAND)
        self._yaw = None
        self._velocity = VelocityPublisher('cmd_vel')
        self._odometry = Subscriber('odom', Odometry, self._on_odometry, 'odometry')
        Subscriber('~target', Float64, self._on_target, queue_size=1)
        warn_of_conflicts('cmd_vel')

    def run(self):
        """In each cycle take the error, multiply it by the gain, and publish."""
        if not self._odometry.wait():
            return
        rate = rospy.Rate(self._hertz, reset=True)
        while not rospy.is_shutdown():
            with callback_lock:
                is_silent = self._watchdog.expired(rospy.get_time())
            if is_silent:
                self._stop()
            else:
                self._control()
            rate.sleep()

    def _control(self):
        yaw = self._yaw
        error = self._turn.error_at(yaw)
        self._velocity.publish(angular=self._turn.speed_for(error))
        print(f'target={self._turn.target} current:{yaw}')
        if self._tolerance == 0 or abs(error) > self._tolerance:
            self._rest.reset()
        elif self._rest.at_rest(rospy.get_time(), error):
            rospy.signal_shutdown('the target has been reached')

    def _stop(self):
        self._velocity.publish()
        rospy.logwarn_throttle(1.0, 'stopping: no odometry arrives')
        self._rest.reset()

    def _on_odometry(self, message):
        self._yaw = yaw_from_orientation(message.pose.pose.orientation)
        self._watchdog.feed(rospy.get_time())

    def _on_target(self, message):
        if math.isfinite(message.data):
            self._turn.target = message.data
        else:
            rospy.logwarn_throttle(1.0, f'target ignored: {message.data} degrees is not finite')


def main():
    """Turn until the target is reached, or until shutdown."""
    RotateRobot().run()


if __name__ == '__main__':
    run_node('rotate_robot', main, __doc__, PARAMETERS)
