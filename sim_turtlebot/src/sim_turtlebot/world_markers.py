"""The shapes of a world file as markers, for RViz and the page."""

import rospy
from geometry_msgs.msg import Point, Pose, Quaternion, Vector3
from std_msgs.msg import ColorRGBA
from visualization_msgs.msg import Marker, MarkerArray

from sim_turtlebot.physics.world_shapes import BOX, CYLINDER, MESH, SPHERE, read_shapes

TYPES = {BOX: Marker.CUBE, CYLINDER: Marker.CYLINDER, SPHERE: Marker.SPHERE,
         MESH: Marker.MESH_RESOURCE}


def publish_world(world):
    """Publish a World's shapes once, latched, where they stand at the start."""
    publisher = rospy.Publisher('~world_markers', MarkerArray, queue_size=1, latch=True)
    # RViz keeps the markers of an earlier simulator until they are deleted.
    publisher.publish([Marker(action=Marker.DELETEALL)] + [
        _marker(number, shape) for number, shape in enumerate(read_shapes(world))])


def _marker(number, shape):
    marker = Marker(ns='world', id=number, type=TYPES[shape.kind], action=Marker.ADD,
                    pose=Pose(Point(*shape.position), Quaternion(*shape.rotation)),
                    scale=Vector3(*shape.size), color=ColorRGBA(*shape.colour))
    marker.header.frame_id = 'world'
    if shape.mesh:
        marker.mesh_resource = f'file://{shape.mesh}'
    return marker
