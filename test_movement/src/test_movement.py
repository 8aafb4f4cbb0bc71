#!/usr/bin/env python3
"""Drive until the robot has moved two metres.

Subscribes:
    moved_distance (std_msgs/Float64): metres travelled, from odom_movement_detector

Publishes:
    cmd_vel (geometry_msgs/Twist): one command per moved_distance message

Parameters:
    ~distance (float, 2.0 m): where to stop; above 0
    ~speed (float, 0.1 m/s): how fast; negative drives backwards; not 0
    ~relative (bool, false): count from the first message instead of from the detector's start
    ~exit_when_done (bool, false): end once the robot has stopped, instead of commanding zero
    ~timeout (float, 1.0 s): stop when no message has come for this long; 0 to 3600; 0 turns it off

The last command the robot receives is zero, however the node ends.
"""

import rospy
from odometry_common.control_loop import ControlLoop
from odometry_common.node import run_node
from odometry_common.parameters import get_flag, get_number
from odometry_common.rivals import warn_of_rivals
from odometry_common.senders import warn_of_two_senders
from odometry_common.subscribing import Subscriber
from odometry_common.timing import RestDetector
from odometry_common.velocity import VelocityPublisher
from std_msgs.msg import Float64
from straight_drive.trip import Trip

REST_BAND = 0.001  # m
REST_DURATION = 0.5  # s


class TestMovement:
    """The node: moved distance in, velocity command out."""

    def __init__(self):
        """Read the parameters; from then on each message is answered with a command."""
        self._distance = get_number(
            '~distance', 2.0, lambda v: v > 0, 'a number of metres above 0')
        self._speed = get_number('~speed', 0.1, lambda v: v != 0, 'a speed in m/s other than 0')
        self._trip = Trip(relative=get_flag('~relative', False))
        self._exit_when_done = get_flag('~exit_when_done', False)
        self.loop = ControlLoop(self._control, self._stop, timeout=get_number(
            '~timeout', 1.0, lambda v: 0 <= v <= 3600, 'from 0 to 3600 s'))
        self._rest = RestDetector(REST_BAND, REST_DURATION)
        self._moving = False
        self._velocity = VelocityPublisher('cmd_vel')
        Subscriber('moved_distance', Float64, self._on_moved_distance)
        warn_of_rivals('cmd_vel')
        warn_of_two_senders('moved_distance', Float64)

    def _on_moved_distance(self, message):
        self.loop.hear(message.data)

    def _control(self, moved_distance, now):
        try:
            speed = self._speed if self._trip.length(moved_distance) < self._distance else 0.0
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
    TestMovement().loop.run()


if __name__ == '__main__':
    run_node('test_movement', main, __doc__)
