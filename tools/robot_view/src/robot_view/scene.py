"""The 3-D scene: a metric grid and robots on it, all below the node WORLD."""

import numpy
from sim_turtlebot.geometry import about_z

from robot_view.looks import add_robot, wxyz

WORLD = '/world'
GHOST_DISTANCE = 0.005  # m between odometry and ground truth; draw both if they differ by more
GHOST_ANGLE = 0.01  # rad
GHOST_COLOUR = (30, 120, 220)
GHOST_OPACITY = 0.35
TRAIL_COLOUR = (230, 120, 20)
TRAIL_HEIGHT = 0.004  # m, above the floor
SCAN_COLOUR = (210, 30, 150)
SCAN_POINT_SIZE = 0.02  # m
START_COLOUR = (40, 160, 70)
START_RADIUS = 0.07  # m
GOAL_COLOUR = (210, 40, 40)
MARK_HEIGHT = 0.008  # m, above the floor; lower ones flicker
SHADOW_COLOUR = (20, 20, 30)
SHADOW_OPACITY = 0.35
SHADOW_RADIUS = 0.21  # m
DAYLIGHT = 3.0
DUSK_COLOUR = (110, 110, 120)  # of the light from below


def add_world(scene):
    """Add lights and a world, a floor with a line at each metre, to an empty viser scene."""
    scene.set_up_direction('+z')
    # With reflections and shadows, a computer without a graphics card draws one frame per second.
    scene.configure_environment_map(None)
    scene.configure_default_lights(cast_shadow=False)
    scene.add_light_hemisphere('/daylight', ground_color=DUSK_COLOUR, intensity=DAYLIGHT)
    scene.add_frame(WORLD, show_axes=False)
    scene.add_grid(f'{WORLD}/floor', infinite_grid=True, cell_size=0.25, cell_color=(215, 215, 220),
                   section_size=1.0, section_color=(170, 170, 178), fade_distance=20.0,
                   plane_color=(248, 248, 250), plane_opacity=1.0)


class RobotModel:
    """The 3-D model of one robot, with its trail, its scan, its start and its goal."""

    def __init__(self, scene, robot, labelled):
        """Add the model of a RobotMonitor to viser's scene.

        :param labelled: whether to show its name beside the robot
        """
        self._robot, self._scene = robot, scene
        name = robot.name or 'robot'
        self._root = f'{WORLD}/robots/{name}'
        self._node = scene.add_frame(self._root, show_axes=False)
        self._body = scene.add_frame(f'{self._root}/body', show_axes=False)
        scene.add_cylinder(f'{self._root}/body/shadow', SHADOW_RADIUS, MARK_HEIGHT / 4,
                           SHADOW_COLOUR, opacity=SHADOW_OPACITY)
        # Marks and ghost are in the odometry's frame.
        self._odometry = scene.add_frame(f'{self._root}/odometry', show_axes=False)
        self._ghost = scene.add_frame(
            f'{self._root}/odometry/ghost', show_axes=False, visible=False)
        self._wheels = add_robot(scene, self._body.name)
        add_robot(scene, self._ghost.name, color=GHOST_COLOUR, opacity=GHOST_OPACITY)
        if labelled:
            scene.add_label(f'{self._root}/body/label', name, position=(0.0, 0.0, 0.55))
        self._add_marks()
        self._trail = scene.add_line_segments(
            f'{self._root}/trail', numpy.zeros((1, 2, 3)), TRAIL_COLOUR, thickness=3.0,
            thickness_units='screen')
        self._scan = scene.add_point_cloud(
            f'{self._root}/scan',
            numpy.zeros((1, 3)),
            SCAN_COLOUR,
            point_size=SCAN_POINT_SIZE,
            point_shape='circle',
            precision='float32',
            point_shading='flat',
            visible=False)
        self._drawn_scan = None

    def close(self):
        """Remove the model from the scene."""
        self._node.remove()

    def move(self):
        """Draw the robot at its pose, and its marks."""
        robot = self._robot
        origin, drift = robot.trace.origin, robot.trace.drift
        _place(self._body, *robot.state.pose)
        _place(self._odometry, (origin.x, origin.y, 0.0), about_z(origin.yaw))
        self._ghost.visible = (numpy.hypot(drift.x, drift.y) > GHOST_DISTANCE
                               or abs(drift.yaw) > GHOST_ANGLE)
        if self._ghost.visible:
            _place(self._ghost, *robot.odometry.pose)
        for frame, joint in self._wheels:
            if joint.name in robot.wheels:
                frame.wxyz = wxyz(joint.rotation_at(robot.wheels[joint.name]))

    def draw_path(self):
        """Draw the trail and the latest scan."""
        robot = self._robot
        points = robot.trace.trail.array()
        if len(points) < 2:
            points = numpy.zeros((2, 2))
        line = numpy.column_stack([points, numpy.full(len(points), TRAIL_HEIGHT)])
        self._trail.points = numpy.stack([line[:-1], line[1:]], axis=1)
        if robot.scan is not self._drawn_scan:
            self._drawn_scan = robot.scan
            state, points = robot.scan
            _place(self._scan, *state.pose)
            self._scan.points = points
            self._scan.visible = len(points) > 0

    def _add_marks(self):
        node = self._odometry.name
        self._scene.add_cylinder(f'{node}/start', START_RADIUS, 2 * MARK_HEIGHT, START_COLOUR)
        self._scene.add_label(f'{node}/start/label', 'start', position=(0.0, 0.3, 0.0))
        target = self._robot.distance_target
        if target is not None:
            self._scene.add_box(
                f'{node}/goal',
                GOAL_COLOUR,
                (0.02, 0.5, 2 * MARK_HEIGHT),
                position=(target, 0.0, 0.0))
            self._scene.add_label(
                f'{node}/goal/label', f'{abs(target):g} m', position=(0.0, -0.3, 0.0))


def _place(node, position, rotation):
    node.position, node.wxyz = position, wxyz(rotation)
