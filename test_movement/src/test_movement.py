#!/usr/bin/env python3
"""Drive until the robot has moved two metres.

Subscribes:
    moved_distance (std_msgs/Float64): metres travelled, from odom_movement_detector

Publishes:
    cmd_vel (geometry_msgs/Twist): one command per moved_distance message

Parameters:
    ~distance (float, 2.0 m, above 0): where to stop
    ~speed (float, 0.1 m/s, other than 0): how fast; negative drives backwards
    ~relative (bool, false): count from the first message instead of from the detector's start,
        so that a second run moves again
    ~exit_when_done (bool, false): exit once the robot has stopped, instead of commanding zero
        for ever
    ~timeout (float, 1.0 s, from 0 to 3600): stop, with a warning, when no message has arrived
        for this long (ROS time, and at least 0.2 s of wall time) while the robot moves; go on
        when messages return; 0 turns it off

The last command the robot receives is zero, however the node ends.
"""

import signal

# Python's own answer to Ctrl-C is a traceback; what is imported below takes its time.
signal.signal(signal.SIGINT, signal.SIG_DFL)

import rospy
from odometry_common.control_loop import ControlLoop
from odometry_common.ending import spin
from odometry_common.node import run_node
from odometry_common.parameters import get_flag, get_number
from odometry_common.rivals import warn_of_rivals
from odometry_common.senders import warn_of_two_senders
from odometry_common.subscribing import Subscriber
from odometry_common.timing import RestDetector
from odometry_common.velocity import VelocityPublisher
from std_msgs.msg import Float64
from straight_drive.parameters import read_drive

REST_BAND = 0.001  # m
REST_DURATION = 0.5  # s


class TestMovement:
    """The node: moved distance in, velocity command out."""

    def __init__(self):
        """Read the parameters; from then on each message is answered with a command."""
        self._drive = read_drive()
        self._exit_when_done = get_flag('~exit_when_done', False)
        self._loop = ControlLoop(self._control, self._stop, timeout=get_number(
            '~timeout', 1.0, lambda v: 0 <= v <= 3600, 'from 0 to 3600 s'))
        self._rest = RestDetector(REST_BAND, REST_DURATION)
        self._moving = False
        self._velocity = VelocityPublisher('cmd_vel')
        Subscriber('moved_distance', Float64, self._on_moved_distance)
        warn_of_rivals('cmd_vel')
        warn_of_two_senders('moved_distance', Float64)

    def _on_moved_distance(self, message):
        self._loop.hear(message.data)

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
    run_node('test_movement', main, __doc__)
