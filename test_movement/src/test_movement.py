#!/usr/bin/env python3
"""Drive until the robot has moved two metres.

Subscribes:
    moved_distance (std_msgs/Float64): metres travelled, from odom_movement_detector

Publishes:
    cmd_vel (geometry_msgs/Twist): one command per moved_distance message

The node always sends zero before it exits.
"""

import signal

# While the imports below run, Ctrl-C ends Python without a traceback.
signal.signal(signal.SIGINT, signal.SIG_DFL)

import rospy
from odometry_common.control_loop import ControlLoop
from odometry_common.node import run_node, spin
from odometry_common.publisher_conflicts import warn_of_conflicts
from odometry_common.subscribing import Subscriber
from odometry_common.timing import RestDetector
from odometry_common.velocity import VelocityPublisher
from std_msgs.msg import Float64
from straight_drive.drive import PARAMETERS, Drive

REST_BAND = 0.001  # m
REST_DURATION = 0.5  # s


class TestMovement:
    """The node: moved distance in, velocity command out."""

    def __init__(self):
        """Read the parameters, then answer each message with a command."""
        parameters = PARAMETERS.read()
        self._drive = Drive(parameters.distance, parameters.speed, parameters.relative)
        self._exit_when_done = parameters.exit_when_done
        self._loop = ControlLoop(self._control, self._stop, parameters.timeout)
        self._rest = RestDetector(REST_BAND, REST_DURATION)
        self._moving = False
        self._velocity = VelocityPublisher('cmd_vel')
        distance = Subscriber('moved_distance', Float64, self._on_moved_distance)
        warn_of_conflicts('cmd_vel')
        warn_of_conflicts('moved_distance', distance.publishers)

    def _on_moved_distance(self, message):
        self._loop.receive(message.data)

    def _control(self, moved_distance, now):
        try:
            speed = self._drive.speed_at(moved_distance)
        except ValueError as error:
            rospy.logwarn_throttle(1.0, f'stopping: {error}')
            speed = 0.0
        self._command(speed)
        if speed != 0:
            self._rest.reset()
        elif self._rest.at_rest(now, moved_distance) and self._exit_when_done:
            rospy.signal_shutdown('the robot has moved and stopped')

    def _stop(self):
        if self._moving:
            self._command(0.0)
            rospy.logwarn('stopping: no moved_distance arrives')

    def _command(self, speed):
        self._velocity.publish(linear=speed)
        if self._moving != (speed != 0):
            self._moving = not self._moving
            rospy.loginfo(f'driving at {speed} m/s' if self._moving else 'stopped')


def main():
    """Answer messages until shutdown."""
    TestMovement()
    spin()


if __name__ == '__main__':
    run_node('test_movement', main, __doc__, PARAMETERS)
