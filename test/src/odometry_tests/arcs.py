"""Motions that are made up, for an odometry to see."""

import math

from odometry_common.geometry import about_z
from odometry_common.kobuki import TICKS_PER_TURN, WHEEL_RADIUS, WHEEL_SEPARATION
from sim_turtlebot.odometry import STILL, Motion

PERIOD = 0.05  # s between two odometries at 20 Hz
TICK = 2 * math.pi * WHEEL_RADIUS / TICKS_PER_TURN  # m


def motion(x=0.0, y=0.0, yaw=0.0, linear=STILL, angular=STILL):
    """Return a Motion on the floor at x, y (m), yaw (rad)."""
    return Motion((x, y, 0.0), about_z(yaw), linear, angular)


def wheel_angles(travel, turn):
    """Return the angles (rad) to which wheels that roll true have turned."""
    difference = turn * WHEEL_SEPARATION / 2
    return (travel - difference) / WHEEL_RADIUS, (travel + difference) / WHEEL_RADIUS


def on_arc(speed, turn_speed, time):
    """Return the true x, y (m), yaw (rad) at a time (s) after a start at zero."""
    yaw = turn_speed * time
    if abs(turn_speed) < 1e-9:
        return speed * time, 0.0, yaw
    radius = speed / turn_speed
    return radius * math.sin(yaw), radius * (1 - math.cos(yaw)), yaw


def drive(odometry, speed, turn_speed=0.0, duration=10.0):
    """Drive an arc; return the odometry after each period."""
    odometry.reset(motion(), (0.0, 0.0))
    times = [number * PERIOD for number in range(1, round(duration / PERIOD) + 1)]
    return [odometry.update(motion(*on_arc(speed, turn_speed, time)),
                            lambda time=time: wheel_angles(speed * time, turn_speed * time), PERIOD)
            for time in times]
