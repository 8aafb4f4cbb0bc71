#!/usr/bin/env python3
"""Turn the robot to a target heading with a P-controller.

Subscribes:
    odom (nav_msgs/Odometry): the robot's odometry
    ~target (std_msgs/Float64): a new target heading in degrees

Publishes:
    cmd_vel (geometry_msgs/Twist): angular.z = kp * (target - yaw), the shorter way round

Parameters:
    ~target (float, 90 degrees, finite): heading to turn to, in the odom frame
    ~kp (float, 0.5 1/s, above 0): gain
    ~rate (float, 10 Hz, from 0.1 to 1000): control rate
    ~max_angular_speed (float, 3.14 rad/s, above 0): the command is clamped to this
    ~tolerance (float, 0.0 degrees, from 0 to 180): 0 controls for ever; above 0, the node exits
        once the heading has stayed this close and the robot has come to rest
    ~timeout (float, 1.0 s, from 0 to 3600): stop, with a warning, when no odometry has arrived
        for this long (ROS time, and at least 0.2 s of wall time); go on when it returns; 0
        turns it off

The last command the robot receives is zero, however the node ends.
"""

import signal

# Python's own answer to Ctrl-C is a traceback; what is imported below takes its time.
signal.signal(signal.SIGINT, signal.SIG_DFL)

import math

import rospy
from heading_control.parameters import read_rate, read_turn
from nav_msgs.msg import Odometry
from odometry_common.control_loop import ControlLoop
from odometry_common.ending import spin
from odometry_common.geometry import yaw_from_orientation
from odometry_common.node import run_node
from odometry_common.parameters import get_number
from odometry_common.rivals import warn_of_rivals
from odometry_common.subscribing import Subscriber
from odometry_common.timing import RestDetector
from odometry_common.velocity import VelocityPublisher
from std_msgs.msg import Float64

REST_BAND = math.radians(0.1)
REST_DURATION = 0.5  # s


class RotateRobot:
    """The node: heading in, angular velocity out."""

    def __init__(self):
        """Read the parameters and listen; the first odometry sets the robot turning."""
        self._turn = read_turn()
        self._tolerance = get_number(
            '~tolerance', 0.0, lambda v: 0 <= v < 180, 'from 0 to 180 degrees')
        timeout = get_number('~timeout', 1.0, lambda v: 0 <= v <= 3600, 'from 0 to 3600 s')
        self._loop = ControlLoop(self._control, self._stop, timeout, period=1 / read_rate())
        self._rest = RestDetector(REST_BAND, REST_DURATION)
        self._velocity = VelocityPublisher('cmd_vel')
        Subscriber('odom', Odometry, self._on_odometry, 'odometry')
        Subscriber('~target', Float64, self._on_target)
        warn_of_rivals('cmd_vel')

    def _on_odometry(self, message):
        yaw = yaw_from_orientation(message.pose.pose.orientation)
        self._loop.hear(yaw, message.header.stamp.to_sec())

    def _on_target(self, message):
        if math.isfinite(message.data):
            self._turn.target = message.data
        else:
            rospy.logwarn_throttle(1.0, f'target ignored: {message.data} degrees is not finite')

    def _control(self, yaw, now):
        error = self._turn.error_at(yaw)
        self._velocity.publish(angular=self._turn.speed_for(error))
        print(f'target={self._turn.target} current:{yaw}')
        if self._tolerance == 0 or abs(error) > math.radians(self._tolerance):
            self._rest.reset()
        elif self._rest.at_rest(now, error):
            rospy.signal_shutdown('the target has been reached')

    def _stop(self):
        rospy.logwarn_throttle(1.0, 'stopping: no odometry arrives')
        self._velocity.stop()
        self._rest.reset()


def main():
    """Turn until the target is reached, or until shutdown."""
    RotateRobot()
    spin()


if __name__ == '__main__':
    run_node('rotate_robot', main, __doc__)
