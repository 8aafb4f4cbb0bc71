"""What is visible of a world file, read from PyBullet."""

from typing import NamedTuple

from odometry_common.native_output import suppressed_output

from sim_turtlebot.geometry import compose, inverse, rotate

with suppressed_output():
    import pybullet

FLOORS = 1  # the first body is the floor, the last ones are the robots
BOX, CYLINDER = pybullet.GEOM_BOX, pybullet.GEOM_CYLINDER
SPHERE, MESH = pybullet.GEOM_SPHERE, pybullet.GEOM_MESH


class VisibleShape(NamedTuple):
    """A shape, with its pose in the world."""

    kind: int  # BOX, CYLINDER, SPHERE or MESH
    size: tuple  # along its x, y and z (m); of a mesh the scale
    mesh: str  # the path of a mesh
    position: tuple  # x, y, z (m)
    rotation: tuple  # quaternion x, y, z, w
    colour: tuple  # red, green, blue, alpha (0 to 1)


def read_shapes(world):
    """Return the VisibleShapes of a World's file; planes and capsules are left out."""
    client = world.client
    bodies = range(FLOORS, client.getNumBodies() - len(world.robots))
    return [_shape(client, *data[:8]) for body in bodies
            for data in client.getVisualShapeData(client.getBodyUniqueId(body))
            if data[2] in (BOX, CYLINDER, SPHERE, MESH)]


def _shape(client, body, link, kind, dimensions, mesh, position, rotation, colour):
    origin, turned = _frame(client, body, link)
    position = tuple(map(sum, zip(origin, rotate(turned, position))))
    return VisibleShape(kind, _size(kind, *dimensions), mesh.decode(), position,
                        compose(turned, rotation), colour)


def _size(kind, first, second, third):
    """Return the size along x, y and z (m) for PyBullet's dimensions of a shape."""
    if kind == CYLINDER:
        length, radius = first, second
        return 2 * radius, 2 * radius, length
    if kind == SPHERE:
        return (2 * first,) * 3
    return first, second, third


def _frame(client, body, link):
    """Return position and rotation of a link; for the first PyBullet keeps the centre of mass."""
    if link >= 0:
        return client.getLinkState(body, link)[4:6]
    position, rotation = client.getBasePositionAndOrientation(body)
    centre, axes = client.getDynamicsInfo(body, link)[3:5]
    turned = compose(rotation, inverse(axes))
    return tuple(here - off for here, off in zip(position, rotate(turned, centre))), turned
