"""The page: scene, panel, plots and pad, the same in every browser."""

import math

from odometry_common.geometry import PlanarPose
from odometry_common.kobuki import MAX_ANGULAR_SPEED, MAX_LINEAR_SPEED

from robot_view.looks import load_links
from robot_view.monitor import RobotMonitor
from robot_view.pad import Pad, add_pad
from robot_view.panel import Readings, SimulationButtons, add_placing
from robot_view.plots import Plots
from robot_view.scene import TWO_METRES, RobotModel, add_floor_and_lights
from robot_view.server import start_server

PANEL_WIDTH = 320  # pixels
FIELD_OF_VIEW = 45  # degrees
CAMERA_DISTANCE = 3.2  # m, from the point at which it looks
CAMERA_HEIGHT = 1.6  # m
HALF_WAY = PlanarPose(TWO_METRES / 2, 0.0, 0.0)
FAR = 3.0  # m


class BrowserPage:
    """The page in all browsers; served at an Address until the process exits."""

    def __init__(self, address):
        self._links = load_links()
        self._robots = {}  # RobotMonitor and RobotModel by namespace
        self._framed = set()
        self._server = start_server(address)
        self._build()
        self._server.on_client_disconnect(self._on_disconnect)

    def _build(self):
        server, gui = self._server, self._server.gui
        gui.configure_theme(show_logo=False, show_share_button=False, control_width='medium')
        add_floor_and_lights(server.scene)
        self._readings = Readings(gui)
        self._choice = gui.add_dropdown('robot', ('',), visible=False)
        self._simulation = SimulationButtons(gui)
        with gui.add_folder('drive: hold a button or an arrow key'):
            self._pad = Pad(lambda: self.chosen if self._robots else None, self._speeds)
            add_pad(gui, self._pad)
            self._linear = gui.add_slider('speed (m/s)', 0.05, MAX_LINEAR_SPEED, 0.05, 0.2)
            self._angular = gui.add_slider(
                'turn (deg/s)', 5, round(math.degrees(MAX_ANGULAR_SPEED)), 5, 45)
        self._placing = add_placing(gui, lambda: self.chosen)
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
        """Namespace of the robot that the readings show and the pad drives."""
        # viser also accepts a value that is not an option.
        options = self._choice.options
        name = self._choice.value if self._choice.value in options else options[0]
        return name and f'{name}/'

    def update_simulation(self, is_simulated, complaint):
        """Show the simulator's controls if there is one, and a complaint unless it is empty."""
        self._simulation.update(is_simulated, complaint)
        self._placing.visible = is_simulated

    def set_robots(self, namespaces):
        """Show the robots in these namespaces and no others."""
        for namespace in set(self._robots) - set(namespaces):
            for part in self._robots.pop(namespace):
                part.close()
        for namespace in namespaces:
            if namespace not in self._robots:
                self._robots[namespace] = RobotMonitor(namespace), RobotModel(
                    self._server.scene, namespace.strip('/') or 'robot', self._links,
                    labelled=len(namespaces) > 1)
        names = tuple(namespace.strip('/') for namespace in namespaces) or ('',)
        if self._choice.options != names:
            self._choice.options = names
        self._choice.visible = len(names) > 1
        if not namespaces:
            self._readings.show({})

    def set_rotating(self, is_rotating):
        """Set which robots rotate.py turns, by a function of their namespaces."""
        for namespace, (monitor, _) in self._robots.items():
            monitor.set_rotating(is_rotating(namespace))

    def move(self):
        """Draw the robots at their current poses."""
        with self._server.atomic():
            for _, monitor, model in self._known():
                with monitor.lock:
                    model.move(monitor)
        self._frame_new_clients()

    def draw(self):
        """Draw the parts that change more slowly: paths, scans, readings, plots."""
        for namespace, monitor, model in self._known():
            with monitor.lock:
                model.draw_path(monitor)
                if namespace == self.chosen:
                    self._readings.show(monitor.readings())
                    self._plots.draw(monitor.trace.history.array())

    def _known(self):
        """Return the namespaces, monitors and models of the robots with odometry."""
        return [(namespace, monitor, model)
                for namespace, (monitor, model) in self._robots.items() if monitor.is_known]

    def _speeds(self):
        return _clamped(self._linear), math.radians(_clamped(self._angular))

    def _frame_new_clients(self):
        """Point the camera of a new browser at the robots, once their poses are known."""
        places = [_middle(monitor) for _, monitor, _ in self._known()]
        if places:
            clients = self._server.get_clients()
            for number in set(clients) - self._framed:
                _point_camera(clients[number].camera, places)
            self._framed = set(clients)

    async def _on_disconnect(self, client):
        # Not on a thread, or the last hold of the same browser could come later.
        self._pad.release(client.client_id)


def _clamped(slider):
    """Return the value of a slider; viser also accepts values beyond its ends, and NaN."""
    if not math.isfinite(slider.value):
        return 0.0
    return min(max(slider.value, slider.min), slider.max)


def _middle(robot):
    """Return x, y (m) of the middle of the first two metres, or of a robot that is far away."""
    half_way, place = robot.trace.origin.then(HALF_WAY)[:2], robot.pose[0][:2]
    return half_way if math.dist(half_way, place) < FAR else place


def _point_camera(camera, places):
    """Show places, a list of x, y (m)."""
    x, y = (sum(values) / len(places) for values in zip(*places))
    distance = CAMERA_DISTANCE + max(math.dist(place, (x, y)) for place in places)
    camera.position = (x, y - distance, CAMERA_HEIGHT)
    camera.look_at = (x, y, 0.1)
