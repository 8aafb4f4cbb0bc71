"""The pad drives a robot while you hold a button or an arrow key."""

import threading
import time

from odometry_common.connections import has_subscriber_within
from odometry_common.velocity import VelocityPublisher

from robot_view import steering
from robot_view.pad_layout import LAYOUT

LONGEST_CONNECTING = 10.0  # s; a robot that takes longer does not listen


class Pad:
    """Publishes velocities on the chosen robot's cmd_vel while a button is held.

    It publishes nothing to robots that it has not driven, not even when the node exits.
    """

    def __init__(self, chosen, speeds):
        """Take two functions.

        :param chosen: returns the namespace of the robot to drive; None if there is none
        :param speeds: returns the linear (m/s) and the angular speed (rad/s)
        """
        self._chosen = chosen
        self._speeds = speeds
        self._steering = steering.Steering()
        self._publishers = {}
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
                self._command(namespace, *shares)

    def _command(self, namespace, forward, left):
        if namespace not in self._publishers:
            self._publishers[namespace] = publisher = VelocityPublisher(f'{namespace}cmd_vel')
            # Wait for the robot, or a first command to stop would be lost.
            has_subscriber_within(publisher, LONGEST_CONNECTING)
            if (forward, left) != steering.STANDSTILL:
                return  # the button may have been released meanwhile
        linear, angular = self._speeds()
        self._publishers[namespace].publish(forward * linear, left * angular)


def add_pad(gui, pad):
    """Add the buttons of a Pad at the current place in viser's GUI."""
    gui.add_html(LAYOUT)
    for name in (steering.FORWARD, steering.LEFT, steering.STOP, steering.RIGHT, steering.BACK):
        _add_button(gui, pad, name)


def _add_button(gui, pad, name):
    """Add a button, which drives while it is held; stop is only clicked."""
    # These run on the event loop, in the order of the messages: no hold comes after its release.
    async def hold(event):
        pad.hold(event.client_id, name)

    async def release(event):
        pad.release(event.client_id, name)

    if name == steering.STOP:
        # Held, it also reaches a robot that the pad has not driven before.
        gui.add_button(name, color='red').on_click(hold)
    else:
        button = gui.add_button(name)
        button.on_hold(callback_hz=steering.HOLD_RATE)(hold)
        button.on_click(release)
