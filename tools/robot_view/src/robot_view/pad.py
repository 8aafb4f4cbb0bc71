"""The pad drives a robot while you hold a button or an arrow key."""

import html
import threading
import time
from pathlib import Path

from odometry_common.velocity import VelocityPublisher

from robot_view import steering

# viser reports key presses, but no releases: the page maps the arrow keys to the buttons.
SCRIPT = Path(__file__).with_name('arrow_keys.js')
MIN_PERIOD = 0.01  # s between two commands, however many pages send holds


class Pad:
    """Publishes velocities on the chosen robot's cmd_vel while a button is held.

    It never publishes to robots that it has not driven, not even when the node exits.
    """

    def __init__(self, chosen, speeds):
        """Start a thread that commands.

        :param chosen: function that returns the namespace of the robot to drive, or None
        :param speeds: function that returns the linear (m/s) and the angular speed (rad/s)
        """
        self._chosen = chosen
        self._speeds = speeds
        self._steering = steering.Steering()
        self._publishers = {}  # by namespace; None until the master answers
        self._lock = threading.Lock()
        self._changed = threading.Event()
        threading.Thread(target=self._drive, daemon=True).start()

    def hold(self, client, button):
        """Hold a button for HOLD_TIMEOUT."""
        robot = self._chosen()
        if robot is not None:
            with self._lock:
                self._steering.hold(client, button, robot, time.monotonic())
            self._changed.set()

    def release(self, client, button=None):
        """Release a button, or all of them."""
        with self._lock:
            self._steering.release(client, button)
        self._changed.set()

    def _drive(self):
        while True:
            self._changed.wait(steering.COMMAND_PERIOD if self._steering.is_driving else None)
            self._changed.clear()
            with self._lock:
                commands = self._steering.commands(time.monotonic())
            for namespace, shares in commands.items():
                self._command(namespace, shares)
            time.sleep(MIN_PERIOD)

    def _command(self, namespace, shares):
        """Publish if the robot is connected. The other robots do not wait for that."""
        if namespace not in self._publishers:
            self._publishers[namespace] = None
            threading.Thread(target=self._advertise, args=[namespace], daemon=True).start()
        publisher = self._publishers[namespace]
        if publisher and publisher.get_num_connections():
            (forward, left), (linear, angular) = shares, self._speeds()
            publisher.publish(forward * linear, left * angular)
            if shares == steering.STANDSTILL:
                self._steering.confirm_stop(namespace)

    def _advertise(self, namespace):
        self._publishers[namespace] = VelocityPublisher(f'{namespace}cmd_vel')


def add_pad(gui, pad):
    """Add the buttons of a Pad at the current place in viser's GUI."""
    # HTML that is inserted runs no <script>.
    script = html.escape(SCRIPT.read_text(encoding='utf-8'))
    gui.add_html(f'<img id="pad" alt="" src="data:," style="display:none" onerror="{script}">')
    for name in (steering.FORWARD, steering.LEFT, steering.STOP, steering.RIGHT, steering.BACK):
        _add_button(gui, pad, name)


def _add_button(gui, pad, name):
    """Add a button that drives while you hold it, or the stop button, which you click."""
    # These run on the event loop in order of the messages, so no hold follows its release.
    async def hold(event):
        pad.hold(event.client_id, name)

    async def release(event):
        pad.release(event.client_id, name)

    if name == steering.STOP:
        # A hold also stops a robot that the pad has not driven before.
        gui.add_button(name, color='red').on_click(hold)
    else:
        button = gui.add_button(name)
        button.on_hold(callback_hz=steering.HOLD_RATE)(hold)
        button.on_click(release)
