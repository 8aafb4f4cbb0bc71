"""The position of a browser's camera.

To follow a robot, the page moves the world, not the cameras:
viser would interrupt a user who drags one.
"""

import math
from itertools import product

import numpy

FIELD_OF_VIEW = math.radians(45)  # vertical
TANGENT = math.tan(FIELD_OF_VIEW / 2)
DIRECTION = numpy.array([0.0, -0.83, 0.56])  # to the camera from what it looks at; of length 1
# Right, up and forward, in the scene.
AXES = numpy.array([
    [1.0, 0.0, 0.0],
    [0.0, 0.56, 0.83],
    -DIRECTION])
DISTANCE = 4.0  # m, from the robot
RADIUS = 0.2  # m, of a robot
MARGIN = 0.5  # m around the places that are shown
TOP = 0.45  # m, above each place; higher than a robot
HEIGHT = 0.15  # m, at which it looks
# x, y, z (m) of a camera that looks at the robot
FROM_ROBOT = DISTANCE * DIRECTION + [0.0, 0.0, HEIGHT]


def look_at_robot(camera):
    """Point a camera at the robot that the world follows."""
    _place(camera, FROM_ROBOT)


def shows(camera, place):
    """Return whether a camera that looks at the robot shows a place, x, y (m) from there."""
    right, up, forward = AXES @ ([*place, 0.0] - FROM_ROBOT)
    return (abs(right) + RADIUS < TANGENT * camera.aspect * forward
            and abs(up) + RADIUS < TANGENT * forward)


def look_at_all(camera, places, aspect):
    """Move a client's camera as close as it can be with all places in view.

    :param places: rows of x, y (m) in the scene
    :param aspect: of the picture; a page that is laid out changes that of the camera meanwhile
    """
    corners = numpy.array(list(product((-MARGIN, MARGIN), (-MARGIN, MARGIN), (0.0, TOP))))
    places = numpy.column_stack([places, numpy.zeros(len(places))])
    right, up, forward = AXES @ (places[:, None] + corners).reshape(-1, 3).T
    across, back = _fit(right, forward, TANGENT * aspect)
    above, farther_back = _fit(up, forward, TANGENT)
    _place(camera, AXES.T @ [across, above, min(back, farther_back)])


def _fit(sideways, forward, tangent):
    """Return both coordinates of the foremost camera that sees these points between its edges."""
    one = (sideways - tangent * forward).max()
    other = (-sideways - tangent * forward).max()
    return (one - other) / 2, -(one + other) / (2 * tangent)


def _place(camera, position):
    camera.position = tuple(position)
    camera.look_at = tuple(position - (position[2] - HEIGHT) / DIRECTION[2] * DIRECTION)
