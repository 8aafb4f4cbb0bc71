"""The 3-D scene: a metric grid and robots on it."""

import numpy
from viser.transforms import SO3

TWO_METRES = 2.0  # m, what the tutorial's robot drives
GHOST_DISTANCE = 0.005  # m between odometry and ground truth from which on both are drawn
GHOST_ANGLE = 0.01  # rad
GHOST_COLOUR = (30, 120, 220)
GHOST_OPACITY = 0.35
TRAIL_COLOUR = (230, 120, 20)
TRAIL_HEIGHT = 0.004  # m, above the floor
SCAN_COLOUR = (210, 30, 150)
SCAN_POINT_SIZE = 0.02  # m
START_COLOUR = (40, 160, 70)
GOAL_COLOUR = (210, 40, 40)
MARK_HEIGHT = 0.008  # m, above the floor; lower ones flicker
DAYLIGHT = 3.0
DUSK_COLOUR = (110, 110, 120)  # of the light from below
SPOKE_COLOUR = (235, 235, 235)
SPOKES = 3  # from rim to rim
SPOKE_WIDTH = 0.008  # m
SPOKE_MARGIN = 0.002  # m, by which it is larger than the wheel


def add_floor_and_lights(scene):
    """Add lights, and a floor with a line at each metre, to an empty viser scene."""
    scene.set_up_direction('+z')
    # Reflections and shadows would leave a computer without a graphics card one frame a second.
    scene.configure_environment_map(None)
    scene.configure_default_lights(cast_shadow=False)
    scene.add_light_hemisphere('/daylight', ground_color=DUSK_COLOUR, intensity=DAYLIGHT)
    scene.add_grid('/floor', infinite_grid=True, cell_size=0.25, cell_color=(215, 215, 220),
                   section_size=1.0, section_color=(170, 170, 178), fade_distance=20.0,
                   plane_color=(248, 248, 250), plane_opacity=1.0)


class RobotFigure:
    """One robot in the scene."""

    def __init__(self, scene, name, links, labelled):
        """Put it into viser's scene.

        :param name: of the scene node, without slashes
        :param links: the robot's model.Links
        :param labelled: whether the name is shown beside the robot
        """
        self._scene = scene
        self._root = f'/robots/{name}'
        self._node = scene.add_frame(self._root, show_axes=False)
        self._body = scene.add_frame(f'{self._root}/body', show_axes=False)
        # The marks and the ghost are drawn in the odometry's frame.
        self._odometry = scene.add_frame(f'{self._root}/odometry', show_axes=False)
        self._ghost = scene.add_frame(
            f'{self._root}/odometry/ghost', show_axes=False, visible=False)
        self._wheels = {}
        for link in links:
            self._add_link(link)
        if labelled:
            scene.add_label(f'{self._root}/body/label', name, position=(0.0, 0.0, 0.55))
        self._add_marks()
        self._trail = scene.add_line_segments(
            f'{self._root}/trail', numpy.zeros((1, 2, 3)), TRAIL_COLOUR, thickness=3.0,
            thickness_units='screen')
        self._scan = scene.add_point_cloud(
            f'{self._root}/scan', numpy.zeros((1, 3)), SCAN_COLOUR, point_size=SCAN_POINT_SIZE,
            point_shape='circle', precision='float32', point_shading='flat', visible=False)
        self._drawn_scan = None

    def remove(self):
        """Remove it from the scene, with all its parts."""
        self._node.remove()

    def move(self, state):
        """Draw it as in a robots.RobotState."""
        self._body.position, self._body.wxyz = state.pose
        self._odometry.position = (state.origin.x, state.origin.y, 0.0)
        self._odometry.wxyz = SO3.from_z_radians(state.origin.yaw).wxyz
        drift = state.drift
        self._ghost.visible = (numpy.hypot(drift.x, drift.y) > GHOST_DISTANCE
                               or abs(drift.yaw) > GHOST_ANGLE)
        if self._ghost.visible:
            self._ghost.position, self._ghost.wxyz = state.odometry
        for joint, (frame, link) in self._wheels.items():
            if joint in state.wheels:
                rotation = SO3.exp(link.axis * state.wheels[joint])
                frame.wxyz = (link.rotation @ rotation).wxyz

    def draw_trail(self, points):
        """Draw the path of the robot: rows of x, y (m)."""
        if len(points) < 2:
            points = numpy.zeros((2, 2))
        line = numpy.column_stack([points, numpy.full(len(points), TRAIL_HEIGHT)])
        segments = numpy.stack([line[:-1], line[1:]], axis=1)
        if not numpy.array_equal(segments.astype(numpy.float32), self._trail.points):
            self._trail.points = segments

    def draw_scan(self, scan):
        """Draw a scan.Scan where it was taken, if there is one."""
        if scan is None or scan is self._drawn_scan:
            return
        self._drawn_scan = scan
        self._scan.position, self._scan.wxyz = scan.pose
        self._scan.points = scan.points
        self._scan.visible = len(scan.points) > 0

    def _add_link(self, link):
        body, ghost = (
            self._scene.add_frame(f'{parent.name}{link.path}', show_axes=False,
                                  position=link.position, wxyz=link.rotation.wxyz)
            for parent in (self._body, self._ghost))
        for number, (colour, mesh) in enumerate(link.meshes.items()):
            self._scene.add_mesh_simple(f'{body.name}/{number}', mesh.vertices, mesh.faces,
                                        color=colour, flat_shading=True)
            self._scene.add_mesh_simple(f'{ghost.name}/{number}', mesh.vertices, mesh.faces,
                                        color=GHOST_COLOUR, opacity=GHOST_OPACITY,
                                        flat_shading=True)
        if link.joint:
            self._wheels[link.joint] = body, link
            self._add_spokes(body, next(iter(link.meshes.values())).extents)

    def _add_spokes(self, wheel, extents):
        """Mark a wheel, so that its turning is seen: little of it shows below the base."""
        across, _, width = extents + SPOKE_MARGIN
        for number in range(SPOKES):
            rotation = SO3.from_z_radians(numpy.pi * number / SPOKES)
            self._scene.add_box(f'{wheel.name}/spoke_{number}', SPOKE_COLOUR,
                                (across, SPOKE_WIDTH, width), wxyz=rotation.wxyz)

    def _add_marks(self):
        node = self._odometry.name
        self._scene.add_cylinder(f'{node}/start', 0.05, 2 * MARK_HEIGHT, START_COLOUR)
        self._scene.add_label(f'{node}/start/label', 'start', position=(0.0, 0.3, 0.0))
        self._scene.add_box(f'{node}/goal', GOAL_COLOUR, (0.02, 0.5, 2 * MARK_HEIGHT),
                            position=(TWO_METRES, 0.0, 0.0))
        self._scene.add_label(f'{node}/goal/label', '2 m', position=(0.0, 0.3, 0.0))
