"""The position of a browser's camera.

To follow a robot, the page moves the world, not the cameras: viser would interrupt a user who drags one.
"""

import math

FIELD_OF_VIEW = math.radians(45)  # vertical
DIRECTION = 0.0, -0.83, 0.56  # from what the camera looks at to the camera; of length 1
DISTANCE = 4.0  # m, from the robot
MARGIN = 0.6  # m around the places that are shown
HEIGHT = 0.15  # m, at which it looks


def look_at_robot(camera):
    """Point a camera at the robot that the world follows."""
    _look(camera, (0.0, 0.0), DISTANCE)


def look_at_all(camera, places):
    """Point a client's camera so that it sees all places, a list of x, y (m) in the scene."""
    (left, right), (near, far) = ((min(values), max(values)) for values in zip(*places))
    tangent = math.tan(FIELD_OF_VIEW / 2)
    distance = max(((right - left) / 2 + MARGIN) / (tangent * camera.aspect),
                   ((far - near) / 2 + MARGIN) / tangent)
    _look(camera, ((left + right) / 2, (near + far) / 2), distance)


def _look(camera, place, distance):
    target = (*place, HEIGHT)
    camera.position = tuple(at + distance * along for at, along in zip(target, DIRECTION))
    camera.look_at = target
