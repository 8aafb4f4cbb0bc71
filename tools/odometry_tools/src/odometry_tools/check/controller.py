"""Fit a proportional controller to commands: which angle they follow, and with what gain."""

import math

import numpy

from odometry_tools.check.scenarios import PERIOD, TARGET

FEWEST, RESIDUAL = 8, 0.003  # commands needed for a fit; largest residual, share of their range
EXACT, WORSE = 1e-5, 10  # smaller residuals are equal; how many times larger the next must be
NARROW = 0.01  # rad; over a smaller range of angles anything is proportional
NO_LAW = '', 0.0, 0.0
LIMITED = 0.99  # share of the fastest command; faster ones may be clamped by the node


def find_controller(run, moves):
    """Return which angle a Run's commands are proportional to, the gain (1/s) and zero (degrees).

    The angle is '' unless one fits much better than the others.
    """
    if len(moves) < FEWEST:
        return NO_LAW
    time, yaw = numpy.array([(pose.time, pose.yaw) for pose in run.odometry]).T
    sent, speed = numpy.array([(command.time, command.angular) for command in moves]).T
    is_free = abs(speed) < LIMITED * abs(speed).max()
    found = []
    for delay in 0, PERIOD, 1 / run.scenario.odom_rate:
        seen = yaw[numpy.searchsorted(time, sent - delay + 1e-6).clip(1) - 1]
        for name, angle in _angles(seen).items():
            law = _law(angle[is_free], speed[is_free])
            if law:
                residual, *gain_and_zero = law
                found.append((max(residual, EXACT), name, *gain_and_zero))
    return _best(found)


def _best(found):
    """Return the law with the smallest residual, if no other angle fits nearly as well."""
    residual, *law = min(found, default=(0.0, *NO_LAW))
    others = [other for other, name, *_ in found if name != law[0]]
    if min(others, default=math.inf) < WORSE * residual:
        return NO_LAW
    return tuple(law)


def _law(angle, speed):
    """Fit speeds (rad/s) that are proportional to angles (rad); return None if they are not.

    :return: largest residual (share of the speeds' range), gain (1/s) and zero (degrees)
    """
    if len(angle) < FEWEST or numpy.ptp(angle) < NARROW:
        return None
    slope, offset = numpy.polyfit(angle, speed, 1)
    residual = abs(slope * angle + offset - speed).max() / (numpy.ptp(speed) or 1.0)
    if slope >= 0 or residual >= RESIDUAL:
        return None
    return residual, -slope, math.degrees(-offset / slope)


def _angles(yaw):
    """Return the angles (rad) that a learner may take for the heading, by name.

    Angles that equal the yaw throughout are left out; "minus" is an error with the wrong sign.
    """
    error = math.radians(TARGET) - yaw
    wrapped = (error + math.pi) % (2 * math.pi) - math.pi
    angles = {
        'yaw_to_360': yaw % (2 * math.pi),
        'half_circle': numpy.arcsin(numpy.sin(yaw)),
        'quaternion': numpy.sin(yaw / 2),
        'minus_wrapped': wrapped - math.radians(TARGET)}
    different = {name: angle for name, angle in angles.items()
                 if not (numpy.allclose(angle, yaw) or numpy.allclose(angle, -yaw))}
    return {'yaw': yaw, 'minus_yaw': -yaw, **different}
