"""What tf makes of the robot's URDF."""

import numpy
import pytest
from sim_turtlebot.geometry import rotate
from sim_turtlebot.kobuki import DEPTH_CAMERA, DEPTH_CAMERA_FRAME
from sim_turtlebot.physics.description import URDF, read_joints
from tf import transformations

JOINTS = {joint.child: joint for joint in read_joints(URDF.read_text())}
# In base_link (m): kobuki_description and turtlebot_description.
PLACES = {'gyro_link': (0.056, 0.062, 0.0202), 'camera_depth_frame': (-0.087, 0.0135, 0.287),
          'wheel_left_link': (0, 0.115, 0.025), 'caster_front_link': (0.115, 0, 0.007)}


def in_base_link(name):
    """Return where a frame is in base_link, as a matrix, by tf's own arithmetic."""
    matrix = numpy.identity(4)
    while name != 'base_link':
        joint = JOINTS[name]
        matrix = (transformations.translation_matrix(joint.position)
                  @ transformations.quaternion_matrix(joint.rotation) @ matrix)
        name = joint.parent
    return matrix


@pytest.mark.parametrize('name, place', PLACES.items())
def test_frames_are_where_a_turtlebot_has_them(name, place):
    assert in_base_link(name)[:3, 3] == pytest.approx(place)


def test_the_scan_is_taken_where_its_frame_is():
    base = JOINTS['base_link'].position
    assert in_base_link(DEPTH_CAMERA_FRAME)[:3, 3] + base == pytest.approx(DEPTH_CAMERA)


def test_an_optical_frame_looks_along_z_and_has_x_to_the_right():
    """REP-103."""
    rotation = JOINTS['camera_depth_optical_frame'].rotation
    assert rotate(rotation, (0.0, 0.0, 1.0)) == pytest.approx((1.0, 0.0, 0.0), abs=1e-15)
    assert rotate(rotation, (1.0, 0.0, 0.0)) == pytest.approx((0.0, -1.0, 0.0), abs=1e-15)
