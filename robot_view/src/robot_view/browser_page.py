"""The page: the scene, the panel, the plots and the pad, alike in every browser."""

import math
import threading

from odometry_common.geometry import PlanarPose
from odometry_common.kobuki import MAX_ANGULAR_SPEED, MAX_LINEAR_SPEED
from odometry_common.shutdown import LONGEST_WAIT

from robot_view.pad import Pad, add_pad
from robot_view.panel import PlacingInputs, Readings, SimulationButtons
from robot_view.plots import Plots
from robot_view.scene import TWO_METRES, RobotModel, add_floor_and_lights
from robot_view.server import start_server

PANEL_WIDTH = 320  # pixels
FIELD_OF_VIEW = 45  # degrees
CAMERA_DISTANCE = 3.2  # m, from what it looks at
CAMERA_HEIGHT = 1.6  # m
HALF_WAY = PlanarPose(TWO_METRES / 2, 0.0, 0.0)
FAR = 3.0  # m


class BrowserPage:
    """The page in all browsers that show it."""

    def __init__(self, address, links):
        """Serve the page at an Address until the process ends; take the robot's looks.Links."""
        self._links = links
        self._models = {}
        self._framed = set()
        self._changed = threading.Event()
        self._server = start_server(address)
        self._build()
        self._server.on_client_connect(lambda _: self._changed.set())
        self._server.on_client_disconnect(self._on_disconnect)

    def _build(self):
        server, gui = self._server, self._server.gui
        gui.configure_theme(show_logo=False, show_share_button=False, control_width='medium')
        add_floor_and_lights(server.scene)
        self._readings = Readings(gui)
        self._choice = gui.add_dropdown('robot', ('',), visible=False)
        self._simulation = SimulationButtons(gui)
        with gui.add_folder('drive: hold a button or an arrow key'):
            self._pad = Pad(lambda: self.chosen if self._models else None, self._speeds)
            add_pad(gui, self._pad)
            self._linear = gui.add_slider('speed (m/s)', 0.05, MAX_LINEAR_SPEED, 0.05, 0.2)
            self._angular = gui.add_slider(
                'turn (deg/s)', 5, round(math.degrees(MAX_ANGULAR_SPEED)), 5, 45)
        self._placing = PlacingInputs(gui, lambda: self.chosen)
        panel = gui.add_panel()
        self._plots = Plots(gui, panel.add_tab('plots'))
        panel.dock_left()
        panel.set_width(PANEL_WIDTH)
        gui.main_panel.dock_right()
        gui.main_panel.set_width(PANEL_WIDTH)
        server.initial_camera.fov = math.radians(FIELD_OF_VIEW)
        _point_camera(server.initial_camera, [HALF_WAY[:2]])

    @property
    def is_open(self):
        """Whether a browser shows the page."""
        return bool(self._server.get_clients())

    @property
    def chosen(self):
        """Namespace of the robot whose readings are shown and which the pad drives."""
        # viser also takes a value that is not an option.
        options = self._choice.options
        name = self._choice.value if self._choice.value in options else options[0]
        return name and f'{name}/'

    def wait(self):
        """Return when a browser connects or disconnects, wake() is called, or after a moment."""
        self._changed.wait(LONGEST_WAIT)
        self._changed.clear()

    def wake(self):
        """End a wait()."""
        self._changed.set()

    def update_simulation(self, is_simulated, complaint=''):
        """Show the controls of a simulator if there is one, and a complaint if there is one."""
        self._simulation.update(is_simulated, complaint)
        self._placing.folder.visible = is_simulated

    def set_robots(self, namespaces):
        """Show these robots and no others."""
        for namespace in set(self._models) - set(namespaces):
            self._models.pop(namespace).remove()
        for namespace in namespaces:
            if namespace not in self._models:
                self._models[namespace] = RobotModel(
                    self._server.scene, namespace.strip('/') or 'robot', self._links,
                    labelled=len(namespaces) > 1)
        names = tuple(namespace.strip('/') for namespace in namespaces) or ('',)
        if self._choice.options != names:
            self._choice.options = names
        self._choice.visible = len(names) > 1
        if not namespaces:
            self._readings.show({})

    def move(self, robots):
        """Draw robots where they are: a dictionary of known RobotMonitors by namespace."""
        with self._server.atomic():
            for namespace, robot in robots.items():
                with robot.lock:
                    self._models[namespace].move(robot)
        self._frame_new_clients(robots.values())

    def draw(self, robots, real_time_factor):
        """Draw what changes more slowly: paths, scans, readings, plots."""
        for namespace, robot in robots.items():
            with robot.lock:
                self._models[namespace].draw_path(robot)
                if namespace == self.chosen:
                    self._readings.show({**robot.readings(), 'real_time_factor': real_time_factor})
                    self._plots.draw(robot.trace.history.array())

    def _speeds(self):
        return _clamped(self._linear), math.radians(_clamped(self._angular))

    def _frame_new_clients(self, robots):
        """Point the camera of a new browser at the robots, once they are known."""
        clients = self._server.get_clients()
        self._framed &= set(clients)
        if not robots:
            return
        for number in set(clients) - self._framed:
            self._framed.add(number)
            _point_camera(clients[number].camera, [_middle(robot) for robot in robots])

    async def _on_disconnect(self, client):
        # Not in a thread: the last hold of the same browser must not come later.
        self._pad.release(client.client_id)
        self._changed.set()


def _clamped(slider):
    """Return the value of a slider; viser also takes values beyond its ends, and NaN."""
    if not math.isfinite(slider.value):
        return 0.0
    return min(max(slider.value, slider.min), slider.max)


def _middle(robot):
    """Return x, y (m) of the middle of the first two metres, or of a robot far from there."""
    half_way, place = robot.trace.origin.then(HALF_WAY)[:2], robot.pose[0][:2]
    return half_way if math.dist(half_way, place) < FAR else place


def _point_camera(camera, places):
    """Show places, a list of x, y (m)."""
    x, y = (sum(values) / len(places) for values in zip(*places))
    distance = CAMERA_DISTANCE + max(math.dist(place, (x, y)) for place in places)
    camera.position = (x, y - distance, CAMERA_HEIGHT)
    camera.look_at = (x, y, 0.1)
