"""The world around the robots, from the simulator's markers."""

from functools import partial

import rospy
from sim_turtlebot.frames import read_pose
from visualization_msgs.msg import Marker, MarkerArray

from robot_view.looks import wxyz
from robot_view.robots import SIMULATOR
from robot_view.scene import WORLD

OPACITY = 0.6  # of the opaque ones, so that a wall does not hide a robot


class WorldModel:
    """Draws boxes, cylinders and spheres of the latest MarkerArray in viser's scene; no meshes."""

    def __init__(self, scene):
        self._adders = {
            Marker.CUBE: scene.add_box,
            Marker.SPHERE: partial(scene.add_icosphere, radius=0.5),
            Marker.CYLINDER: partial(scene.add_cylinder, radius=0.5)}
        self._handles = []
        rospy.Subscriber(f'{SIMULATOR}/world_markers', MarkerArray, self._draw)

    def _draw(self, message):
        while self._handles:
            self._handles.pop().remove()
        for number, marker in enumerate(message.markers):
            if marker.type in self._adders:
                self._add(f'{WORLD}/shapes/{number}', marker)

    def _add(self, name, marker):
        position, rotation = read_pose(marker.pose)
        size, colour = marker.scale, marker.color
        self._handles.append(self._adders[marker.type](
            name,
            color=(colour.r, colour.g, colour.b),
            opacity=OPACITY * colour.a,
            position=position,
            wxyz=wxyz(rotation),
            scale=(size.x, size.y, size.z)))
