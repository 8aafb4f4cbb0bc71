"""What navigation knows: a map, the plan to the goal, and where amcl believes the robot to be."""

import numpy
import rospy
from geometry_msgs.msg import PoseWithCovarianceStamped
from nav_msgs.msg import OccupancyGrid, Path
from rospy.numpy_msg import numpy_msg
from sim_turtlebot.frames import read_pose

from robot_view.looks import wxyz
from robot_view.scene import WORLD

OCCUPIED = 65  # per cent, from which map_server counts a cell as occupied
CELL_SIZE = 0.05  # m, gmapping's default
HEIGHT = 0.006  # m, above the floor; lower ones flicker
MAP_COLOUR, PLAN_COLOUR = (60, 60, 70), (40, 160, 70)
AXES_LENGTH, AXES_RADIUS = 0.4, 0.015  # m, of amcl's pose


class NavigationModel:
    """Draws the latest messages; the frame map must be that of the world."""

    def __init__(self, scene):
        self._scene = scene
        # As an array: a list of millions of numbers would keep the pad waiting.
        rospy.Subscriber('map', numpy_msg(OccupancyGrid), self._draw_map)
        rospy.Subscriber('move_base/NavfnROS/plan', Path, self._draw_plan)
        rospy.Subscriber('amcl_pose', PoseWithCovarianceStamped, self._draw_pose)

    def _draw_map(self, message):
        if len(message.data) != message.info.height * message.info.width:
            return
        cells = occupied_cells(message)
        if numpy.isfinite(cells).all():
            self._scene.add_point_cloud(f'{WORLD}/map', cells, MAP_COLOUR, CELL_SIZE,
                                        point_shape='square', precision='float32',
                                        point_shading='flat')

    def _draw_plan(self, message):
        points = numpy.array([_on_floor(pose.pose) for pose in message.poses]).reshape(-1, 3)
        segments = numpy.stack([points[:-1], points[1:]], axis=1)
        if numpy.isfinite(segments).all():
            self._scene.add_line_segments(f'{WORLD}/plan', segments, PLAN_COLOUR,
                                          thickness=3.0, thickness_units='screen')

    def _draw_pose(self, message):
        pose = message.pose.pose
        position, rotation = _on_floor(pose), wxyz(read_pose(pose)[1])
        if numpy.isfinite([*position, *rotation]).all():
            self._scene.add_frame(f'{WORLD}/amcl', axes_length=AXES_LENGTH,
                                  axes_radius=AXES_RADIUS, position=position, wxyz=rotation)


def occupied_cells(message):
    """Return the middles of an OccupancyGrid's occupied cells: rows of x, y, z (m)."""
    info = message.info
    cells = numpy.array(message.data).reshape(info.height, info.width)
    rows, columns = numpy.nonzero(cells >= OCCUPIED)
    x = info.origin.position.x + (columns + 0.5) * info.resolution
    y = info.origin.position.y + (rows + 0.5) * info.resolution
    return numpy.column_stack([x, y, numpy.full(len(rows), HEIGHT)])


def _on_floor(pose):
    return pose.position.x, pose.position.y, HEIGHT
