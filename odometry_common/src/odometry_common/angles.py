"""Angles."""

import math


def wrap_to_pi(angle):
    """Return the same angle (rad) in (-pi, pi]."""
    wrapped = math.remainder(angle, 2 * math.pi)
    return math.pi if wrapped == -math.pi else wrapped
