"""The world around the robots, from the simulator's markers."""

from visualization_msgs.msg import Marker

OPACITY = 0.6  # of the opaque ones, so that a wall does not hide a robot


class WorldModel:
    """Draws the boxes, cylinders and spheres of a MarkerArray in viser's scene; no meshes."""

    def __init__(self, scene, root):
        """Draw below the scene node `root`, the frame `world`."""
        self._scene, self._root = scene, root
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
        position, turn, size = marker.pose.position, marker.pose.orientation, marker.scale
        colour = marker.color
        options = {'color': tuple(round(255 * part) for part in (colour.r, colour.g, colour.b)),
                   'opacity': OPACITY * colour.a, 'position': (position.x, position.y, position.z),
                   'wxyz': (turn.w, turn.x, turn.y, turn.z), 'scale': (size.x, size.y, size.z)}
        if marker.type == Marker.CUBE:
            handle = self._scene.add_box(name, dimensions=(1.0, 1.0, 1.0), **options)
        elif marker.type == Marker.CYLINDER:
            handle = self._scene.add_cylinder(name, 0.5, 1.0, **options)
        elif marker.type == Marker.SPHERE:
            handle = self._scene.add_icosphere(name, 0.5, **options)
        else:
            return
        self._handles.append(handle)
