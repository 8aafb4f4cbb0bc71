"""When a tutorial's robot has done what it was told, by plain numbers."""

import math

REST_SPEED = 1e-3  # m/s
REST_STEP = 1e-5  # m between two odometries
HEADING_TOLERANCE = 0.1  # degrees
REST_ANGULAR_SPEED = 5e-3  # rad/s; a P-controller creeps towards its target


def stands(step, linear):
    """Return whether a robot stands by its odometry and in truth.

    :param step: m from the odometry before
    :param linear: true velocity of the robot, along x and y at least (m/s)
    """
    return step < REST_STEP and math.hypot(linear[0], linear[1]) < REST_SPEED


def has_turned(error, angular_speed):
    """Return whether a heading is reached and the robot hardly turns.

    :param error: from the heading by odometry to the wanted one (rad)
    :param angular_speed: true one, about z (rad/s)
    """
    return (abs(math.degrees(error)) <= HEADING_TOLERANCE
            and abs(angular_speed) < REST_ANGULAR_SPEED)
