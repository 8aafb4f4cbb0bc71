"""The visible shapes of a world file as markers, for RViz and the page."""

import rospy
from geometry_msgs.msg import Point, Pose, Quaternion, Vector3
from std_msgs.msg import ColorRGBA
from visualization_msgs.msg import Marker, MarkerArray

FLOORS = 1  # the first body is the floor, the last ones are the robots


def publish_world(world):
    """Publish a World's shapes once, latched, where they stand at the start."""
    publisher = rospy.Publisher('~world_markers', MarkerArray, queue_size=1, latch=True)
    # RViz keeps the markers of an earlier simulator until they are deleted.
    publisher.publish([Marker(action=Marker.DELETEALL), *make_markers(world)])


def make_markers(world):
    """Return the Markers of a World's file; planes and capsules are left out."""
    client = world.client
    types = {client.GEOM_BOX: Marker.CUBE, client.GEOM_CYLINDER: Marker.CYLINDER,
             client.GEOM_SPHERE: Marker.SPHERE, client.GEOM_MESH: Marker.MESH_RESOURCE}
    bodies = range(FLOORS, client.getNumBodies() - len(world.robots))
    shapes = [shape[:8] for body in bodies
              for shape in client.getVisualShapeData(client.getBodyUniqueId(body))
              if shape[2] in types]
    return [_marker(client, number, types[shape[2]], *shape) for number, shape in enumerate(shapes)]


def _marker(client, number, kind, body, link, _, dimensions, mesh, position, rotation, colour):
    position, rotation = client.multiplyTransforms(
        *_frame(client, body, link), position, rotation)
    marker = Marker(ns='world', id=number, type=kind, action=Marker.ADD,
                    pose=Pose(Point(*position), Quaternion(*rotation)),
                    scale=Vector3(*_size(kind, *dimensions)), color=ColorRGBA(*colour))
    marker.header.frame_id = 'world'
    if mesh:
        marker.mesh_resource = f'file://{mesh.decode()}'
    return marker


def _size(kind, first, second, third):
    """Return the size along x, y and z (m), of a mesh the scale, for PyBullet's dimensions."""
    if kind == Marker.CYLINDER:
        length, radius = first, second
        return 2 * radius, 2 * radius, length
    if kind == Marker.SPHERE:
        return (2 * first,) * 3
    return first, second, third


def _frame(client, body, link):
    """Return position and rotation of a link; for the first PyBullet keeps the centre of mass."""
    if link >= 0:
        return client.getLinkState(body, link)[4:6]
    centre = client.getDynamicsInfo(body, link)[3:5]
    return client.multiplyTransforms(
        *client.getBasePositionAndOrientation(body), *client.invertTransform(*centre))
