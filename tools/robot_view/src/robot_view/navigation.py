"""What navigation knows: a map, the plan to the goal, and where amcl believes the robot to be."""

from functools import partial

import numpy
import rospy
from geometry_msgs.msg import PoseWithCovarianceStamped
from nav_msgs.msg import OccupancyGrid, Path

OCCUPIED = 65  # per cent, from which map_server counts a cell as occupied
CELL_SIZE = 0.05  # m, gmapping's default
HEIGHT = 0.006  # m, above the floor; lower ones flicker
MAP_COLOUR, PLAN_COLOUR = (60, 60, 70), (40, 160, 70)
AXES_LENGTH, AXES_RADIUS = 0.4, 0.015  # m, of amcl's pose


class NavigationModel:
    """Draws the latest messages; the frame map must be that of the world."""

    def __init__(self, scene, root):
        """Draw below the scene node `root`, the frame `world`."""
        self._scene, self._root = scene, root
        self._latest = {}  # numbers that are not drawn yet, by the function that draws them
        for topic, kind, read, draw in (
                ('map', OccupancyGrid, occupied_cells, self._draw_map),
                ('move_base/NavfnROS/plan', Path, _points, self._draw_plan),
                ('amcl_pose', PoseWithCovarianceStamped, _pose, self._draw_pose)):
            rospy.Subscriber(topic, kind, partial(self._receive, read, draw))

    def draw(self):
        """Draw what has arrived since the last call."""
        while self._latest:
            draw, numbers = self._latest.popitem()
            draw(numbers)

    def _receive(self, read, draw, message):
        # Read here, where rospy only reports a message that contradicts itself.
        numbers = read(message)
        if numpy.isfinite(numbers).all():
            self._latest[draw] = numbers

    def _draw_map(self, cells):
        self._scene.add_point_cloud(f'{self._root}/map', cells, MAP_COLOUR, CELL_SIZE, point_shape='square',
                                    precision='float32', point_shading='flat')

    def _draw_plan(self, points):
        segments = numpy.stack([points[:-1], points[1:]], axis=1)
        self._scene.add_line_segments(f'{self._root}/plan', segments, PLAN_COLOUR, thickness=3.0,
                                      thickness_units='screen')

    def _draw_pose(self, pose):
        self._scene.add_frame(f'{self._root}/amcl', axes_length=AXES_LENGTH, axes_radius=AXES_RADIUS,
                              position=pose[:3], wxyz=pose[3:])


def occupied_cells(message):
    """Return the middles of an OccupancyGrid's occupied cells: rows of x, y, z (m)."""
    info = message.info
    rows, columns = numpy.nonzero(numpy.array(message.data).reshape(info.height, info.width) >= OCCUPIED)
    x, y = info.origin.position.x, info.origin.position.y
    return numpy.column_stack([x + (columns + 0.5) * info.resolution, y + (rows + 0.5) * info.resolution,
                               numpy.full(len(rows), HEIGHT)])


def _points(message):
    """Return the way of a Path: rows of x, y, z (m)."""
    places = [(pose.pose.position.x, pose.pose.position.y, HEIGHT) for pose in message.poses]
    return numpy.array(places).reshape(-1, 3)


def _pose(message):
    """Return x, y, z (m) and the quaternion w, x, y, z."""
    position, turn = message.pose.pose.position, message.pose.pose.orientation
    return numpy.array([position.x, position.y, HEIGHT, turn.w, turn.x, turn.y, turn.z])
