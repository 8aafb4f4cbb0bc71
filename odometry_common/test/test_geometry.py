"""Angles, orientations and poses in the plane."""

import math

import pytest
from geometry_msgs.msg import Point, Pose, Quaternion
from hypothesis import given
from hypothesis import strategies as st
from odometry_common.geometry import (
    PlanarPose,
    euler_from_orientation,
    planar_pose,
    wrap_to_pi,
    yaw_from_orientation,
)
from tf.transformations import euler_from_quaternion, quaternion_from_euler

angles = st.floats(-1e6, 1e6)
yaws = st.floats(-math.pi, math.pi)
coordinates = st.floats(-1e3, 1e3)
poses = st.builds(PlanarPose, coordinates, coordinates, yaws)


@given(angles)
def test_a_wrapped_angle_is_the_same_direction_within_half_a_turn(angle):
    """No turn is longer than half a circle, and it ends where the long way would."""
    wrapped = wrap_to_pi(angle)
    assert -math.pi < wrapped <= math.pi
    assert math.cos(wrapped) == pytest.approx(math.cos(angle), abs=1e-6)
    assert math.sin(wrapped) == pytest.approx(math.sin(angle), abs=1e-6)


@pytest.mark.parametrize('degrees, expected', [
    (180, 180), (-180, 180), (270, -90), (720, 0), (540, 180), (-270, 90), (181, -179)])
def test_the_wrapped_error_takes_the_shorter_way(degrees, expected):
    """Targets of the contract from a heading of zero."""
    assert math.degrees(wrap_to_pi(math.radians(degrees))) == pytest.approx(expected)


@given(yaws, yaws, yaws, st.floats(0.99, 1.01))
def test_the_angles_are_those_of_the_tutorial_to_the_last_bit(roll, pitch, yaw, length):
    """The original gives tf what is in the message."""
    parts = [length * part for part in quaternion_from_euler(roll, pitch, yaw)]
    assert euler_from_orientation(Quaternion(*parts)) == euler_from_quaternion(parts)


@given(yaws, st.floats(1e-3, 1e3))
def test_a_quaternion_of_any_length_has_its_yaw(yaw, length):
    """A driver need not normalise."""
    x, y, z, w = (length * part for part in quaternion_from_euler(0, 0, yaw))
    found = yaw_from_orientation(Quaternion(x, y, z, w))
    assert wrap_to_pi(found - yaw) == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize('length', [1e-320, 1e-200, 1e-9, 1e9, 1e200])
def test_no_length_is_too_short_or_too_long_for_a_quaternion(length):
    """Where its square would be zero or infinite, too."""
    yaw = yaw_from_orientation(Quaternion(0, 0, length, length))
    assert yaw == pytest.approx(math.pi / 2)


@pytest.mark.parametrize('parts', [
    (0, 0, 0, 0), (math.nan, 0, 0, 1), (0, math.inf, 0, 1), (0, 0, 0, -math.inf)])
def test_a_quaternion_that_is_no_rotation_is_refused(parts):
    """The message names the numbers."""
    with pytest.raises(ValueError, match='is no rotation'):
        euler_from_orientation(Quaternion(*parts))


@given(coordinates, coordinates, st.floats(-3, 3))
def test_a_planar_pose_is_where_the_robot_is_and_looks(x, y, yaw):
    """Its height does not matter."""
    orientation = Quaternion(*quaternion_from_euler(0, 0, yaw))
    assert planar_pose(Pose(Point(x, y, 5.0), orientation)) == pytest.approx((x, y, yaw))


def test_a_pose_is_ahead_and_to_the_left_of_the_one_before():
    """From a robot that looks to the left, ahead is to the left."""
    pose = PlanarPose(1.0, 2.0, math.pi / 2).then(PlanarPose(3.0, 0.5, 0.25))
    assert pose == pytest.approx((0.5, 5.0, math.pi / 2 + 0.25))


@given(poses)
def test_a_pose_and_its_inverse_lead_back_to_the_origin(pose):
    """In either order."""
    assert pose.then(pose.inverse()) == pytest.approx((0, 0, 0), abs=1e-9)
    assert pose.inverse().then(pose) == pytest.approx((0, 0, 0), abs=1e-9)
