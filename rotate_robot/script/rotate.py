#!/usr/bin/env python3
"""Turn the robot to a target heading with a P-controller.

Subscribes:
    odom (nav_msgs/Odometry): the robot's odometry
    ~target (std_msgs/Float64): a new target heading in degrees

Publishes:
    cmd_vel (geometry_msgs/Twist): angular.z = kp * (target - yaw), the shorter way round

Parameters:
    ~target (float, 90 degrees): heading to turn to, in the odom frame
    ~kp (float, 0.5 1/s): gain
    ~rate (float, 10 Hz): control rate
    ~max_angular_speed (float, 3.14 rad/s): the command is clamped to this
    ~tolerance (float, 0.0 degrees): 0 controls for ever; above 0, the node ends once the
        heading has stayed this close and the robot has come to rest
    ~timeout (float, 1.0 s): stop when no odometry has come for this long; 0 turns it off

The last command the robot receives is zero, however the node ends.
"""

import math

import rospy
from nav_msgs.msg import Odometry
from odometry_common.node import print_line, run_node
from odometry_common.parameters import get_number
from odometry_common.timing import RestDetector, Watchdog
from odometry_common.velocity import VelocityPublisher
from rotate_robot.heading import euler_from_orientation, turn_command, wrap_to_pi
from std_msgs.msg import Float64

REST_BAND = math.radians(0.1)
REST_DURATION = 0.5  # s


class RotateRobot:
    """The node: heading in, angular velocity out."""

    def __init__(self):
        """Read the parameters and listen; nothing is commanded before control() is called."""
        self._target_deg = get_number('~target', 90.0, allowed='a finite number of degrees')
        self._kp = get_number('~kp', 0.5, lambda v: v > 0, 'a gain in 1/s above 0')
        rate = get_number('~rate', 10.0, lambda v: 0.1 <= v <= 1000, 'from 0.1 to 1000 Hz')
        self._max_angular_speed = get_number(
            '~max_angular_speed', 3.14, lambda v: v > 0, 'a speed in rad/s above 0')
        tolerance = get_number('~tolerance', 0.0, lambda v: 0 <= v < 180, 'from 0 to 180 degrees')
        self._tolerance = math.radians(tolerance)
        self._watchdog = Watchdog(
            get_number('~timeout', 1.0, lambda v: 0 <= v <= 3600, 'from 0 to 3600 s'))
        self._rest = RestDetector(REST_BAND, REST_DURATION)
        self._yaw = None
        self._velocity = VelocityPublisher('cmd_vel')
        rospy.Subscriber('odom', Odometry, self._on_odometry, tcp_nodelay=True)
        rospy.Subscriber('~target', Float64, self._on_target)
        self._rate = rospy.Rate(rate, reset=True)

    def control(self):
        """Command the robot at the control rate until it is done or the node is shut down."""
        while not rospy.is_shutdown():
            if self._yaw is not None:
                self._step()
                if self._done():
                    return
            self._rate.sleep()

    def _step(self):
        if self._watchdog.expired(rospy.get_time()):
            rospy.logwarn_throttle(1.0, 'stopping: no odometry arrives')
            self._velocity.stop()
            return
        target = math.radians(self._target_deg)
        command = turn_command(target, self._yaw, self._kp, self._max_angular_speed)
        self._velocity.publish(angular=command)
        print_line(f'target={self._target_deg} current:{self._yaw}')

    def _done(self):
        error = wrap_to_pi(math.radians(self._target_deg) - self._yaw)
        if self._tolerance == 0 or abs(error) > self._tolerance:
            self._rest.reset()
            return False
        return self._rest.at_rest(rospy.get_time(), error)

    def _on_odometry(self, message):
        try:
            yaw = euler_from_orientation(message.pose.pose.orientation)[2]
        except ValueError as error:
            rospy.logwarn_throttle(1.0, f'odometry ignored: {error}')
            return
        self._watchdog.feed(rospy.get_time())
        self._yaw = yaw

    def _on_target(self, message):
        if not math.isfinite(message.data):
            rospy.logwarn_throttle(1.0, f'target ignored: {message.data} degrees is not finite')
            return
        self._target_deg = message.data


def main():
    """Turn until the target is reached, or until shutdown."""
    RotateRobot().control()


if __name__ == '__main__':
    run_node('rotate_robot', main)
