"""The turn towards a heading."""


def turn_command(error, kp, max_angular_speed):
    """Return the angular velocity (rad/s) of a P-controller on the heading.

    :param error: wanted minus actual heading (rad), wrapped so that the shorter way is taken
    :param kp: gain (1/s)
    :param max_angular_speed: limit of the result (rad/s)
    """
    return max(-max_angular_speed, min(max_angular_speed, kp * error))
