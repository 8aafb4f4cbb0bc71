"""Angles, orientations and rotations, against tf's."""

import math

import pytest
from geometry_msgs.msg import Quaternion
from hypothesis import example, given
from hypothesis import strategies as st
from odometry_common.orientation import euler_from_orientation, yaw_from_orientation
from sim_turtlebot.geometry import (
    about_z,
    compose,
    height_of_z,
    inverse,
    mean_twist,
    rotate,
    yaw_of,
)
from tf import transformations as tf

angles = st.floats(-math.pi, math.pi)
rotations = st.builds(lambda roll, pitch, yaw: tuple(tf.quaternion_from_euler(roll, pitch, yaw)),
                      angles, st.floats(-1.5, 1.5), angles)
vectors = st.tuples(*[st.floats(-1e4, 1e4)] * 3)


def close(values, scale=1.0):
    """Return what equals the values but for the last bits of numbers of that scale."""
    return pytest.approx(tuple(values), rel=0, abs=scale * 1e-14)


@given(angles, angles, angles, st.floats(0.99, 1.01))
def test_the_angles_are_those_of_the_tutorial_to_the_last_bit(roll, pitch, yaw, length):
    parts = [length * part for part in tf.quaternion_from_euler(roll, pitch, yaw)]
    assert euler_from_orientation(Quaternion(*parts)) == tf.euler_from_quaternion(parts)


@pytest.mark.parametrize('length', [1e-320, 1e-200, 1e-9, 0.5, 2.0, 1e9, 1e200])
def test_a_quaternion_of_any_length_has_its_yaw(length):
    """A driver need not normalise; the length's square may be zero or infinite."""
    yaw = yaw_from_orientation(Quaternion(0, 0, length, length))
    assert yaw == pytest.approx(math.pi / 2)


@given(rotations, rotations, vectors)
def test_rotations_are_those_of_tf(outer, inner, vector):
    """In double precision: a vector of 10 km is turned to 1e-14 of that and not to 1e-7."""
    assert compose(outer, inner) == close(tf.quaternion_multiply(outer, inner))
    matrix = tf.quaternion_matrix(outer)[:3, :3]
    assert rotate(outer, vector) == close(matrix @ vector, scale=1e5)
    assert rotate(inverse(outer), rotate(outer, vector)) == close(vector, scale=1e5)
    assert height_of_z(outer) == pytest.approx(matrix[2, 2], abs=1e-14)
    yaw = tf.euler_from_quaternion(outer)[2]
    assert math.remainder(yaw_of(outer) - yaw, math.tau) == pytest.approx(0, abs=1e-12)


@given(rotations, st.floats(-0.7, 0.7), angles, st.sampled_from([1, -1]))
@example((0.0, 0.0, 0.0, 1.0), 0.0, 0.0, 1)
def test_the_mean_twist_of_an_arc_is_the_one_that_was_driven(start, speed, turn_speed, sign):
    """In whatever orientation, and whichever of its two quaternions is given."""
    duration = 0.1
    turned = compose(start, about_z(turn_speed * duration))
    angle = turn_speed * duration
    chord = speed * duration * (math.sin(angle / 2) / (angle / 2) if angle else 1.0)
    end = rotate(compose(start, about_z(angle / 2)), (chord, 0.0, 0.0))
    twist = mean_twist(((0.0, 0.0, 0.0), start), (end, tuple(sign * part for part in turned)),
                       duration)
    assert twist[0] == pytest.approx((speed, 0.0, 0.0), abs=1e-12)
    assert twist[1] == pytest.approx((0.0, 0.0, turn_speed), abs=1e-12)
