"""Rotations, against tf's."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st
from odometry_common.geometry import (
    about,
    about_z,
    compose,
    from_rpy,
    height_of_z,
    inverse,
    is_upright,
    mean_twist,
    rotate,
    yaw_of,
)
from tf import transformations

angles = st.floats(-math.pi, math.pi)
rotations = st.builds(
    lambda roll, pitch, yaw: tuple(transformations.quaternion_from_euler(roll, pitch, yaw)),
    angles, st.floats(-1.5, 1.5), angles)
vectors = st.tuples(*[st.floats(-1e4, 1e4)] * 3)


def close(values, scale=1.0):
    """Return what equals the values but for the last bits of numbers of that scale."""
    return pytest.approx(tuple(values), rel=0, abs=scale * 1e-14)


@given(rotations, rotations)
def test_one_after_the_other_is_their_product(outer, inner):
    """The inner one first."""
    expected = transformations.quaternion_multiply(outer, inner)
    assert compose(outer, inner) == close(expected)


@given(rotations, vectors)
def test_a_vector_is_turned_as_by_the_matrix(rotation, vector):
    """In double precision: to 1e-14 of 10 km and not to 1e-7."""
    matrix = transformations.quaternion_matrix(rotation)[:3, :3]
    assert rotate(rotation, vector) == close(matrix @ vector, scale=1e5)


@given(rotations, vectors)
def test_the_inverse_turns_back(rotation, vector):
    """As if nothing had happened."""
    assert rotate(inverse(rotation), rotate(rotation, vector)) == close(vector, scale=1e5)


@given(rotations)
def test_the_yaw_is_the_third_of_the_euler_angles(rotation):
    """Whatever roll and pitch are."""
    expected = transformations.euler_from_quaternion(rotation)[2]
    assert math.remainder(yaw_of(rotation) - expected, 2 * math.pi) == pytest.approx(0, abs=1e-12)


@given(angles)
def test_the_yaw_of_a_rotation_about_z_is_its_angle(yaw):
    """All the way round."""
    assert about_z(yaw) == close(transformations.quaternion_about_axis(yaw, (0, 0, 1)))
    assert math.remainder(yaw_of(about_z(yaw)) - yaw, 2 * math.pi) == pytest.approx(0, abs=1e-14)


@given(rotations, st.floats(-0.7, 0.7), st.floats(-math.pi, math.pi), st.sampled_from([1, -1]))
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


@given(rotations, vectors)
def test_between_a_pose_and_itself_there_is_no_motion(rotation, place):
    """But for the last bits."""
    twist = mean_twist((place, rotation), (place, rotation), 0.05)
    assert [*twist[0], *twist[1]] == pytest.approx([0.0] * 6, abs=1e-12)


@given(st.sampled_from([(1, 0, 0), (0, 1, 0), (0, 0, 1), (0.6, 0.0, -0.8)]), angles)
def test_a_rotation_about_an_axis_is_that_of_tf(axis, angle):
    """Also about one that is askew."""
    assert about(axis, angle) == close(transformations.quaternion_about_axis(angle, axis))


@given(angles, angles, angles)
def test_roll_pitch_and_yaw_are_those_of_urdf(roll, pitch, yaw):
    """About the fixed axes, roll first."""
    expected = transformations.euler_matrix(roll, pitch, yaw, 'sxyz')[:3, :3]
    for axis in (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0):
        assert rotate(from_rpy(roll, pitch, yaw), axis) == close(expected @ axis)


@given(rotations)
def test_the_height_of_z_is_that_of_the_turned_axis(rotation):
    """The last number of the matrix."""
    expected = transformations.quaternion_matrix(rotation)[2, 2]
    assert height_of_z(rotation) == pytest.approx(expected, abs=1e-14)


@pytest.mark.parametrize('degrees, upright', [
    (0, True), (59.9, True), (-59.9, True), (60.1, False), (90, False), (180, False), (-90, False)])
@pytest.mark.parametrize('axis', [(1, 0, 0), (0, 1, 0), (0.6, 0.8, 0)])
@pytest.mark.parametrize('yaw', [0.0, 2.0])
def test_what_leans_more_than_60_degrees_is_not_upright(degrees, upright, axis, yaw):
    """To any side, whichever way it looks."""
    half = math.radians(degrees) / 2
    lean = *(math.sin(half) * part for part in axis), math.cos(half)
    assert is_upright(compose(lean, about_z(yaw))) == upright
