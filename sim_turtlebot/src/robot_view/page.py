"""The page: a viser server with the scene, the panel, the plots and the pad in it."""

import atexit
import math
import threading
import warnings

import rich
import viser
from odometry_common.geometry import PlanarPose
from odometry_common.kobuki import MAX_ANGULAR_SPEED, MAX_LINEAR_SPEED
from odometry_common.parameters import ParameterError
from odometry_common.shutdown import LONGEST_WAIT

from robot_view.guard import guarded
from robot_view.messages import checked
from robot_view.pad import Pad, add_pad
from robot_view.panel import Readings, SimulationButtons
from robot_view.placing import PlacingInputs
from robot_view.plots import Plots
from robot_view.scene import TWO_METRES, RobotFigure, add_floor_and_lights

PANEL_WIDTH = 320  # pixels
FIELD_OF_VIEW = 45  # degrees
CAMERA_DISTANCE = 3.2  # m, from what it looks at, backwards and to the right
CAMERA_HEIGHT = 1.6  # m
HALF_WAY = PlanarPose(TWO_METRES / 2, 0.0, 0.0)
FAR = 3.0  # m


class Page:
    """What every browser shows: they all show the same."""

    def __init__(self, address, links):
        """Serve the page at a free Address until the process ends; take the robot's model.Links."""
        self._links = links
        self._figures = {}
        self._framed = set()
        self._changed = threading.Event()
        # viser prints with rich that it begins and ends, verbose or not.
        rich.get_console().quiet = True
        # A browser may be closed at any moment, also while this writes to it.
        warnings.filterwarnings('ignore', 'Queued a .* on a closed connection')
        self._inputs = {}
        with guarded(address.own_hosts, lambda data: checked(data, self._inputs)):
            self._server = viser.ViserServer(address.ip, address.port, label='TurtleBot 2',
                                             verbose=False)
        # With it viser would wait for busy browsers to say goodbye, for seconds.
        atexit.unregister(self._server.stop)
        if self._server.get_port() != address.port:
            raise ParameterError('~port', address.port, 'a port that nobody listens on')
        self._build()
        # viser has no public name for it.
        self._inputs = self._server.gui._gui_input_handle_from_uuid
        self._server.on_client_connect(lambda _: self._changed.set())
        self._server.on_client_disconnect(self._on_disconnect)

    def _build(self):
        server, gui = self._server, self._server.gui
        gui.configure_theme(show_logo=False, show_share_button=False, control_width='medium')
        add_floor_and_lights(server.scene)
        self._readings = Readings(gui)
        self._choice = gui.add_dropdown('robot', ('',), visible=False)
        self._choice.on_update(self._choose)
        self._simulation = SimulationButtons(gui)
        with gui.add_folder('drive: hold a button or an arrow key'):
            self.pad = Pad(lambda: (self._linear.value, math.radians(self._angular.value)))
            add_pad(gui, self.pad)
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
        """Whether there is a browser that shows the page."""
        return bool(self._server.get_clients())

    @property
    def chosen(self):
        """Namespace of the robot whose figures are shown and which the pad drives."""
        return self._choice.value and f'{self._choice.value}/'

    def wait(self):
        """Return when a browser has connected or disconnected, or wake() was called, or soon."""
        self._changed.wait(LONGEST_WAIT)
        self._changed.clear()

    def wake(self):
        """End a wait()."""
        self._changed.set()

    def update_simulation(self, services, complaint=''):
        """Show what there is for a simulation, as SimulationButtons.update() does."""
        self._placing.show(self._simulation.update(services, complaint))

    async def _choose(self, _event):
        """Tell the pad; on the event loop, like its buttons: no hold can overtake a choice."""
        self.pad.choose(self._to_drive)

    def _to_drive(self):
        """Return the namespace of the robot that the pad drives; None while none is listed."""
        return self.chosen if self._figures else None

    def set_robots(self, namespaces):
        """Show these robots and no others."""
        for namespace in set(self._figures) - set(namespaces):
            self._figures.pop(namespace).remove()
        for namespace in namespaces:
            if namespace not in self._figures:
                self._figures[namespace] = RobotFigure(
                    self._server.scene, namespace.strip('/') or 'robot', self._links,
                    labelled=len(namespaces) > 1)
        names = tuple(namespace.strip('/') for namespace in namespaces) or ('',)
        if self._choice.options != names:
            self._choice.options = names
        self._choice.visible = len(names) > 1
        self.pad.choose(self._to_drive)
        if not namespaces:
            self._readings.show({})

    def move(self, states):
        """Draw robots where they are: a dictionary of robots.RobotState by namespace."""
        with self._server.atomic():
            for namespace, state in states.items():
                self._figures[namespace].move(state)
        self._frame_new_clients(states)

    def draw(self, states, rate):
        """Draw what changes more slowly: trails, scans, figures, plots."""
        for namespace, state in states.items():
            self._figures[namespace].draw_trail(state.trail)
            self._figures[namespace].draw_scan(state.scan)
        state = states.get(self.chosen)
        if state:
            self._readings.show({**state._asdict(), 'real_time_factor': rate})
            self._plots.draw(state.history)

    def _frame_new_clients(self, states):
        """Point the camera of a new page at the robots, once they are known."""
        clients = self._server.get_clients()
        self._framed &= set(clients)
        if not states:
            return
        for number in set(clients) - self._framed:
            self._framed.add(number)
            _point_camera(clients[number].camera, [_middle(state) for state in states.values()])

    async def _on_disconnect(self, client):
        # Here, and not in a thread: the last hold of the same browser must not come later.
        self.pad.release(client.client_id)
        self._changed.set()


def _middle(state):
    """Return x, y (m) of the middle of the first two metres, or of a robot far from there."""
    half_way, robot = state.origin.then(HALF_WAY)[:2], state.pose.position[:2]
    return half_way if math.dist(half_way, robot) < FAR else robot


def _point_camera(camera, places):
    """Show places, a list of x, y (m)."""
    x, y = (sum(values) / len(places) for values in zip(*places))
    distance = CAMERA_DISTANCE + max(math.dist(place, (x, y)) for place in places)
    camera.position = (x, y - distance, CAMERA_HEIGHT)
    camera.look_at = (x, y, 0.1)
