"""The world around the robots, from the simulator's markers."""

from functools import partial

from visualization_msgs.msg import Marker

OPACITY = 0.6  # of the opaque ones, so that a wall does not hide a robot


class WorldModel:
    """Draws the boxes, cylinders and spheres of a MarkerArray in viser's scene; no meshes."""

    def __init__(self, scene, root):
        """Draw below the scene node `root`, the frame `world`."""
        self._root = root
        self._adders = {Marker.CUBE: scene.add_box, Marker.SPHERE: partial(scene.add_icosphere, radius=0.5),
                        Marker.CYLINDER: partial(scene.add_cylinder, radius=0.5)}
        self._drawn, self._handles = None, []

    def draw(self, markers):
        """Draw a MarkerArray, unless it is the one that is drawn already, or None."""
        if markers is self._drawn:
            return
        self._drawn = markers
        while self._handles:
            self._handles.pop().remove()
        for number, marker in enumerate(markers.markers):
            self._add(f'{self._root}/shapes/{number}', marker)

    def _add(self, name, marker):
        if marker.type not in self._adders:
            return
        position, turn, size, colour = marker.pose.position, marker.pose.orientation, marker.scale, marker.color
        self._handles.append(self._adders[marker.type](
            name, color=(colour.r, colour.g, colour.b), opacity=OPACITY * colour.a,
            position=(position.x, position.y, position.z), wxyz=(turn.w, turn.x, turn.y, turn.z),
            scale=(size.x, size.y, size.z)))
