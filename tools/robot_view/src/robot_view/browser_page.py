"""The page: scene, panel, plots and pad, the same in every browser."""

import math
import threading
from pathlib import Path

import rospy
from sim_turtlebot.kobuki import MAX_ANGULAR_SPEED, MAX_LINEAR_SPEED

from robot_view.camera import FIELD_OF_VIEW, look_at_robot
from robot_view.client_view import ClientView
from robot_view.navigation import NavigationModel
from robot_view.pad import Pad, add_pad
from robot_view.panel import Readings, SimulationButtons, add_placing
from robot_view.plots import Plots
from robot_view.scene import RobotModel, add_world
from robot_view.server import start_server
from robot_view.world_model import WorldModel

PANEL_WIDTH = 316  # pixels; viser adds four
FRAME_PERIOD = 0.05  # s of wall time between two pictures
FRAMES = 4  # between two updates of trails, readings and plots
IDLE_PERIOD = 0.5  # s between two checks for a browser
STYLE = Path(__file__).with_name('page.css')


class BrowserPage:
    """The page in all browsers; served at an Address until the process exits."""

    def __init__(self, address, robots):
        """Show Robots."""
        self._robots = robots
        self._models = {}  # RobotModel by RobotMonitor
        self._views = {}  # ClientView by the client's id
        self._server = start_server(address)
        scene = self._server.scene
        add_world(scene)
        WorldModel(scene)
        NavigationModel(scene)
        self._build()
        self._server.on_client_connect(self._on_connect)
        self._server.on_client_disconnect(self._on_disconnect)

    def _build(self):
        server, gui = self._server, self._server.gui
        gui.configure_theme(show_logo=False, show_share_button=False, control_width='medium')
        gui.add_html(f'<style>{STYLE.read_text(encoding="utf-8")}</style>')
        self._readings = Readings(gui)
        self._choice = gui.add_dropdown('robot', ('',), visible=False)
        self._simulation = SimulationButtons(gui, self._robots)
        with gui.add_folder('drive: hold a button or an arrow key') as self._drive:
            self._pad = Pad(lambda: self._chosen and self._chosen.namespace, self._speeds)
            add_pad(gui, self._pad)
            self._linear = gui.add_slider(
                'speed (m/s)', 0.05, MAX_LINEAR_SPEED, 0.05, 0.2, marks=())
            self._angular = gui.add_slider(
                'turn (deg/s)', 5, round(math.degrees(MAX_ANGULAR_SPEED)), 5, 45, marks=())
        self._plots = Plots(gui, gui.add_folder('plots'))
        self._placing = add_placing(
            gui, lambda *pose: self._chosen and self._chosen.put(*pose))
        gui.main_panel.dock_right()
        gui.main_panel.set_width(PANEL_WIDTH)
        server.initial_camera.fov = FIELD_OF_VIEW
        look_at_robot(server.initial_camera)

    def run(self):
        """Draw while a browser shows the page, until shutdown."""
        pause = threading.Event()  # lockstep would warn of a node that calls time.sleep()
        while not rospy.core.is_shutdown_requested():
            if not self._server.get_clients():
                pause.wait(IDLE_PERIOD)
                continue
            self._draw()
            for _ in range(FRAMES):
                self._move()
                pause.wait(FRAME_PERIOD)

    @property
    def _chosen(self):
        """The RobotMonitor chosen in the panel, by default the first; None without robots."""
        monitors, name = self._robots.monitors, self._choice.value
        # viser also accepts a value that is not an option.
        return monitors.get(name and f'{name}/', next(iter(monitors.values()), None))

    def _move(self):
        """Draw the robots at their current poses, and let the views follow the chosen one."""
        with self._server.atomic():
            for robot, model in self._known():
                with robot.lock:
                    model.move()
                    x, y, _ = robot.state.planar
                for view in list(self._views.values()) if robot is self._chosen else ():
                    view.follow(x, y)

    def _draw(self):
        """Draw what changes more slowly: the list of robots, paths, scans, readings, plots."""
        self._find_models()
        self._simulation.update()
        self._placing.visible = self._robots.is_simulated
        for robot, model in self._known():
            with robot.lock:
                model.draw_path()
                if robot is self._chosen:
                    self._readings.show(robot)
                    self._plots.draw(robot.trace.history.array(), robot.distance_target)

    def _find_models(self):
        """Show the robots that are recorded, and no others."""
        robots = list(self._robots.monitors.values())
        for robot in self._models.keys() - set(robots):
            self._models.pop(robot).close()
        for robot in robots:
            if robot not in self._models:
                labelled = len(robots) > 1
                self._models[robot] = RobotModel(self._server.scene, robot, labelled=labelled)
        names = tuple(robot.name for robot in robots) or ('',)
        if self._choice.options != names:
            self._choice.options = names
        self._choice.visible = len(names) > 1

    def _known(self):
        """Return the robots with odometry, each with its model."""
        return [(robot, model) for robot, model in self._models.items() if robot.odometry]

    def _speeds(self):
        return _clamped(self._linear), math.radians(_clamped(self._angular))

    def _find_places(self):
        """Return x, y (m) in the world of the chosen robot, its start, and all paths and goals."""
        places, chosen = [], self._chosen
        for robot in sorted(self._robots.monitors.values(), key=lambda one: one is not chosen):
            with robot.lock:
                places += robot.places() if robot.odometry else []
        return places

    def _on_connect(self, client):
        self._views[client.client_id] = ClientView(client, self._drive.order, self._find_places)

    async def _on_disconnect(self, client):
        # Not on a thread, or the last hold of the same browser could come later.
        self._pad.release(client.client_id)
        self._views.pop(client.client_id, None)


def _clamped(slider):
    """Return the value of a slider; viser also accepts values beyond its ends, and NaN."""
    if not math.isfinite(slider.value):
        return 0.0
    return min(max(slider.value, slider.min), slider.max)
