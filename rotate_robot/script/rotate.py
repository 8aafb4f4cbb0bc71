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

import math
import threading

import rospy
from nav_msgs.msg import Odometry
from odometry_common.node import run_node
from odometry_common.parameters import get_number
from odometry_common.rivals import warn_of_rivals
from odometry_common.timing import Metronome, RestDetector, Watchdog
from odometry_common.velocity import VelocityPublisher
from rotate_robot.heading import euler_from_orientation, turn_command, wrap_to_pi
from std_msgs.msg import Float64

REST_BAND = math.radians(0.1)
REST_DURATION = 0.5  # s
PERIODS_UNTIL_LATE = 2.5  # without odometry; the clock may be heard a period after it
CLOCK_LAG = 60.0  # s of simulated time, by which a busy machine may hear the clock late


class RotateRobot:
    """The node: heading in, angular velocity out."""

    def __init__(self):
        """Read the parameters and listen; the first odometry sets the robot turning."""
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
        self._metronome = Metronome(1 / rate)
        self._rate = rospy.Rate(rate, reset=True)
        self._late = PERIODS_UNTIL_LATE / rate
        self._yaw = None
        self._heard = None
        self._lock = threading.Lock()
        self._velocity = VelocityPublisher('cmd_vel')
        warn_of_rivals('cmd_vel')
        rospy.Subscriber('odom', Odometry, self._on_odometry, tcp_nodelay=True)
        rospy.Subscriber('~target', Float64, self._on_target)

    def carry_on(self):
        """Keep up the control rate, until shutdown, while odometry is slow or has ceased."""
        while not rospy.is_shutdown():
            self._rate.sleep()
            with self._lock:
                now = rospy.get_time()
                if self._heard is not None and now - self._heard > self._late:
                    self._control(now)

    def _on_odometry(self, message):
        """Control at the arrival of odometry: no command then rests on an older heading."""
        try:
            yaw = euler_from_orientation(message.pose.pose.orientation)[2]
        except ValueError as error:
            rospy.logwarn_throttle(1.0, f'odometry ignored: {error}')
            return
        with self._lock:
            stamp = message.header.stamp.to_sec()
            now = _time_heard(stamp)
            self._yaw, self._heard = yaw, now
            self._watchdog.feed(now)
            if self._metronome.is_due(stamp or now):
                self._control(now)

    def _control(self, now):
        if self._watchdog.expired(now):
            rospy.logwarn_throttle(1.0, 'stopping: no odometry arrives')
            self._velocity.stop()
            self._rest.reset()
            return
        error = wrap_to_pi(math.radians(self._target_deg) - self._yaw)
        self._velocity.publish(angular=turn_command(error, self._kp, self._max_angular_speed))
        print(f'target={self._target_deg} current:{self._yaw}')
        if self._tolerance == 0 or abs(error) > self._tolerance:
            self._rest.reset()
        elif self._rest.at_rest(now, error):
            rospy.signal_shutdown('the target has been reached')

    def _on_target(self, message):
        if not math.isfinite(message.data):
            rospy.logwarn_throttle(1.0, f'target ignored: {message.data} degrees is not finite')
            return
        self._target_deg = message.data


def _time_heard(stamp):
    """Return when odometry with this stamp (s) was heard, in ROS time (s).

    Simulated time comes on a connection of its own, and may come after odometry that is newer.
    Taken for the present, it would make a silence of the time that it is behind.
    """
    now = rospy.get_time()
    behind = not rospy.rostime.is_wallclock() and now < stamp < now + CLOCK_LAG
    return stamp if behind else now


def main():
    """Turn until the target is reached, or until shutdown."""
    RotateRobot().carry_on()


if __name__ == '__main__':
    run_node('rotate_robot', main, __doc__)
