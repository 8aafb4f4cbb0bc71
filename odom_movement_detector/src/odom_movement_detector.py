#!/usr/bin/env python3
"""Add up how far the robot has moved, and publish it.

Subscribes:
    odom (nav_msgs/Odometry): the robot's odometry
    moved_distance/reset (std_msgs/Empty): start counting from zero again

Publishes:
    moved_distance (std_msgs/Float64): metres travelled, once per odometry message

Parameters:
    ~min_step (float, 0.0 m): a displacement from the last counted position below this
        is not counted yet
    ~max_speed (float, 5.0 m/s): a step that implies more than this is a jump of the
        odometry and is not counted; 0 turns the check off
"""

import math
import threading

import rospy
from nav_msgs.msg import Odometry
from odometry_common.node import run_node
from odometry_common.parameters import get_number
from odometry_common.publishing import advertise
from std_msgs.msg import Empty, Float64

SMALLEST_DISTANCE = 1e-6  # m; a smaller total is published as zero, as in the tutorial
CLOSE_TIMEOUT = 0.5  # s, for a subscriber that has stopped reading
DELIVERY_JITTER = 0.05  # s, by which arrival times may misstate the time between messages


class DistanceCounter:
    """The sum of the steps between consecutive positions in the plane."""

    def __init__(self, min_step=0.0, max_speed=5.0):
        """Take the smallest step counted (m) and the speed (m/s, 0: any) of a jump."""
        self._min_step = min_step
        self._max_speed = max_speed
        self._total = 0.0
        self._counted_position = None
        self._position = None
        self._stamp = None
        self._arrival = None
        self._spare_time = 0.0

    @property
    def distance(self):
        """Metres counted so far; exactly 0.0 while under a micrometre."""
        return self._total if self._total >= SMALLEST_DISTANCE else 0.0

    def reset(self):
        """Start from zero at the last position."""
        self._total = 0.0
        self._counted_position = self._position

    def add(self, x, y, stamp, arrival):
        """Take the robot's next position.

        :param x, y: position (m)
        :param stamp, arrival: when it was measured and when it arrived (s)
        :return: None, or why this step was not counted
        :raises ValueError: if x or y is not finite; nothing has changed then
        """
        if not (math.isfinite(x) and math.isfinite(y)):
            raise ValueError(f'the position ({x}, {y}) is not finite')
        jump = self._jump(x, y, stamp, arrival)
        self._position, self._stamp, self._arrival = (x, y), stamp, arrival
        if jump or self._counted_position is None:
            self._counted_position = self._position
            return jump
        step = _distance(self._position, self._counted_position)
        if step >= self._min_step:
            self._total += step
            self._counted_position = self._position
        return None

    def _jump(self, x, y, stamp, arrival):
        """Say why the way from the last position to this one is no movement, or None."""
        if self._position is None:
            return None
        uncounted = _distance((x, y), self._counted_position)
        if not math.isfinite(self._total + uncounted):
            return f'a step of {uncounted} m is no movement'
        if stamp < self._stamp:
            return f'the time stamp went back by {self._stamp - stamp:.3f} s'
        if self._max_speed == 0:
            return None
        if stamp > self._stamp:
            available = stamp - self._stamp
        else:
            available = max(0.0, arrival - self._arrival) + self._spare_time
        step = _distance((x, y), self._position)
        needed = step / self._max_speed
        if needed > available:
            return f'a step of {step:.3f} m in {available:.3f} s is faster than ~max_speed'
        # Messages that waited on the way arrive in one burst: the time that one of them
        # did not need is there for the next.
        self._spare_time = min(available - needed, DELIVERY_JITTER)
        return None


class MovementDetector:
    """The node: odometry in, moved distance out."""

    def __init__(self):
        """Read the parameters, then publish from the first odometry message on."""
        self._counter = DistanceCounter(
            min_step=get_number('~min_step', 0.0, lambda v: v >= 0, 'a number of metres from 0'),
            max_speed=get_number('~max_speed', 5.0, lambda v: v >= 0, 'a speed in m/s from 0'))
        self._lock = threading.Lock()
        self._wake_up = threading.Event()
        self._closed = False
        rospy.on_shutdown(self._close)
        # The publisher comes first: a callback may run as soon as its subscriber exists.
        self._publisher = advertise('moved_distance', Float64)
        rospy.Subscriber('odom', Odometry, self._on_odometry, tcp_nodelay=True)
        rospy.Subscriber('moved_distance/reset', Empty, self._on_reset)

    def wait_for_odometry(self):
        """Return when the first odometry has come, or at shutdown; say so each second."""
        while not (self._wake_up.wait(timeout=1.0) or rospy.is_shutdown()):
            rospy.loginfo('waiting for odometry on %s', rospy.resolve_name('odom'))

    def _on_odometry(self, message):
        position = message.pose.pose.position
        stamp = message.header.stamp.to_sec()
        try:
            with self._lock:
                if self._closed:
                    return
                jump = self._counter.add(position.x, position.y, stamp, rospy.get_time())
                self._publisher.publish(self._counter.distance)
        except ValueError as error:
            rospy.logwarn_throttle(1.0, f'odometry ignored: {error}')
            return
        if not self._wake_up.is_set():
            self._wake_up.set()
        if jump:
            rospy.logwarn_throttle(1.0, f'not counted: {jump}')

    def _on_reset(self, _message):
        with self._lock:
            self._counter.reset()
        rospy.loginfo('counting from zero again')

    def _close(self):
        """Publish nothing more: rospy closes the topics next."""
        # A subscriber that has stopped reading may hold the lock up.
        locked = self._lock.acquire(timeout=CLOSE_TIMEOUT)
        self._closed = True
        if locked:
            self._lock.release()
        self._wake_up.set()


def _distance(a, b):
    return math.hypot(a[0] - b[0], a[1] - b[1])


def main():
    """Count until shutdown."""
    MovementDetector().wait_for_odometry()
    rospy.spin()


if __name__ == '__main__':
    run_node('movement_detector_node', main, anonymous=True)
