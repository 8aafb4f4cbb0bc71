#!/usr/bin/env python3
"""Drive until the robot has moved two metres.

Subscribes:
    moved_distance (std_msgs/Float64): metres travelled, from odom_movement_detector

Publishes:
    cmd_vel (geometry_msgs/Twist): one command per moved_distance message

Parameters:
    ~distance (float, 2 m, above 0): where to stop
    ~speed (float, 0.1 m/s, other than 0): how fast; negative drives backwards
    ~relative (bool, false): count from the first message, not from the detector's start
    ~exit_when_done (bool, false): exit once the robot has stopped; false: keep commanding zero
    ~timeout (float, 1 s, from 0 to 3600): stop and warn while no message arrives for this long (ROS
        time, and at least 0.2 s of wall time); 0: never

The node always sends zero before it exits.
"""

import math

import rospy
from odometry_common.node import run_node, spin
from odometry_common.publisher_conflicts import warn_of_conflicts
from odometry_common.rest import DISTANCE_BAND, RestDetector
from odometry_common.subscribing import Subscriber, callback_lock
from odometry_common.velocity import VelocityPublisher
from odometry_common.watchdog import Watchdog
from std_msgs.msg import Float64
from straight_drive.drive import PARAMETERS, Drive

SILENCE_PERIOD = 0.1  # s of wall time between two checks for silence


class TestMovement:
    """The node: moved distance in, velocity command out."""

    def __init__(self):
        parameters = PARAMETERS.read()
        self._drive = Drive(parameters.distance, parameters.speed, parameters.relative)
        self._exit_when_done = parameters.exit_when_done
        self._watchdog = Watchdog(parameters.timeout)
        self._rest = RestDetector(DISTANCE_BAND)
        self._reset = rospy.resolve_name('moved_distance/reset')
        self._speed = None  # of the last command
        self._velocity = VelocityPublisher('cmd_vel')
        self._distances = Subscriber('moved_distance', Float64, self._on_moved_distance)
        warn_of_conflicts('cmd_vel')
        warn_of_conflicts('moved_distance')

    def run(self):
        """Answer messages until shutdown."""
        if self._distances.wait():
            spin(self._stop_if_silent, SILENCE_PERIOD)

    def _stop_if_silent(self):
        """Command zero while no moved distance arrives."""
        with callback_lock:
            if self._speed and self._watchdog.expired(rospy.get_time()):
                self._command(0.0)
                rospy.logwarn('stopping: no moved_distance arrives')

    def _on_moved_distance(self, message):
        now = rospy.get_time()
        self._watchdog.feed(now)
        try:
            speed = self._drive.speed_at(message.data)
        except ValueError as error:
            rospy.logwarn_throttle(1.0, f'stopping: {error}')
            speed = 0.0
        if self._speed is None and speed == 0 and math.isfinite(message.data):
            rospy.loginfo(f'moved_distance is {message.data:.3f} m already: nothing to drive. '
                          f'Reset it (rostopic pub -1 {self._reset} std_msgs/Empty), '
                          'or set _relative:=true')
        self._command(speed)
        if speed != 0:
            self._rest.reset()
        elif self._rest.at_rest(now, message.data) and self._exit_when_done:
            rospy.signal_shutdown('the robot has moved and stopped')

    def _command(self, speed):
        self._velocity.publish(linear=speed)
        if bool(self._speed) != (speed != 0):
            rospy.loginfo(f'driving at {speed} m/s' if speed else 'stopped')
        self._speed = speed


def main():
    """Answer messages until shutdown."""
    TestMovement().run()


if __name__ == '__main__':
    run_node('test_movement', main, __doc__, PARAMETERS)
