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

import math
import threading

import rospy
from odometry_common.node import run_node
from odometry_common.parameters import get_flag, get_number
from odometry_common.rivals import warn_of_rivals
from odometry_common.senders import SenderWatch
from odometry_common.timing import RestDetector, Watchdog
from odometry_common.velocity import VelocityPublisher
from std_msgs.msg import Float64

CHECKS_PER_TIMEOUT = 10
REST_BAND = 0.001  # m
REST_DURATION = 0.5  # s
WALL_TIMEOUT = 0.2  # s; at up to five times real time it is the shorter one


class Drive:
    """Decides from each moved distance alone how fast to go."""

    def __init__(self, distance, speed, relative=False):
        """Go at `speed` (m/s) for `distance` (m), from zero or from the first distance seen."""
        self._distance = distance
        self._speed = speed
        self._start = None if relative else 0.0

    def speed_at(self, moved_distance):
        """Return the speed to command (m/s) after `moved_distance` (m).

        :raises ValueError: if moved_distance is not finite
        """
        if not math.isfinite(moved_distance):
            raise ValueError(f'the moved distance {moved_distance} is not finite')
        if self._start is None:
            self._start = moved_distance
        return self._speed if moved_distance - self._start < self._distance else 0.0


class TestMovement:
    """The node: moved distance in, velocity command out."""

    def __init__(self):
        """Read the parameters; from then on each message is answered with a command."""
        self._drive = Drive(
            distance=get_number('~distance', 2.0, lambda v: v > 0, 'a number of metres above 0'),
            speed=get_number('~speed', 0.1, lambda v: v != 0, 'a speed in m/s other than 0'),
            relative=get_flag('~relative', False))
        self._exit_when_done = get_flag('~exit_when_done', False)
        timeout = get_number('~timeout', 1.0, lambda v: 0 <= v <= 3600, 'from 0 to 3600 s')
        self._watchdog = Watchdog(timeout, min(timeout, WALL_TIMEOUT))
        self._rest = RestDetector(REST_BAND, REST_DURATION)
        self._senders = SenderWatch()
        self._moving = False
        self._lock = threading.Lock()
        self._velocity = VelocityPublisher('cmd_vel')
        warn_of_rivals('cmd_vel')
        rospy.Subscriber('moved_distance', Float64, self._on_moved_distance, tcp_nodelay=True)
        if timeout:
            period = rospy.Duration(timeout / CHECKS_PER_TIMEOUT)
            rospy.Timer(period, self._check_silence, reset=True)

    def _on_moved_distance(self, message):
        with self._lock:
            now = rospy.get_time()
            self._watchdog.feed(now)
            try:
                speed = self._drive.speed_at(message.data)
            except ValueError as error:
                rospy.logwarn_throttle(1.0, f'stopping: {error}')
                speed = 0.0
            self._command(speed)
            if speed != 0:
                self._rest.reset()
            elif self._rest.at_rest(now, message.data) and self._exit_when_done:
                rospy.signal_shutdown('the robot has moved and stopped')
            self._check_sender(message)

    def _check_sender(self, message):
        rivals = self._senders.rivals(message._connection_header['callerid'])
        if rivals:
            rospy.logwarn('moved_distance comes from both %s and %s: end one of them', *rivals)

    def _check_silence(self, _event):
        with self._lock:
            if self._moving and self._watchdog.expired(rospy.get_time()):
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
    rospy.spin()


if __name__ == '__main__':
    run_node('test_movement', main, __doc__)
