"""Decide from plain numbers whether a tutorial's robot has arrived."""

import math

REST_SPEED = 1e-3  # m/s
REST_STEP = 1e-5  # m between two odometries
HEADING_TOLERANCE = 0.1  # degrees
REST_ANGULAR_SPEED = 5e-3  # rad/s; a P-controller approaches its target ever more slowly


def is_at_rest(step, linear):
    """Return whether a robot is at rest by its odometry and in truth.

    :param step: distance from the previous odometry (m)
    :param linear: true velocity of the robot, along x and y at least (m/s)
    """
    return step < REST_STEP and math.hypot(linear[0], linear[1]) < REST_SPEED


def has_turned(error, angular_speed):
    """Return whether the robot has reached a heading and hardly turns.

    :param error: from the heading by odometry to the target (rad)
    :param angular_speed: the true one, about z (rad/s)
    """
    return (abs(math.degrees(error)) <= HEADING_TOLERANCE
            and abs(angular_speed) < REST_ANGULAR_SPEED)
