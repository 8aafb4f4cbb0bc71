"""The viewer node: it draws robots on the page while a browser shows it."""

import threading
import time

import rospy

from robot_view.browser_page import BrowserPage

FRAME_PERIOD = 0.05  # s of wall time between two pictures
DRAWING_PERIOD = 0.2  # s between two updates of trails, readings and plots
IDLE_PERIOD = 0.5  # s between two checks for a browser


class Viewer:
    """Draws Robots while a browser shows the page."""

    def __init__(self, address, robots):
        self._robots = robots
        self._page = BrowserPage(address, robots)
        self._drawn = 0.0  # time of the last drawing (s)

    def run(self):
        """View until shutdown."""
        pause = threading.Event()  # lockstep would warn of a node that only calls time.sleep()
        while not rospy.core.is_shutdown_requested():
            is_open = self._page.is_open
            for monitor in self._robots.monitors.values():
                monitor.watch(is_open)
            if is_open:
                self._view()
                time.sleep(FRAME_PERIOD)
            else:
                pause.wait(IDLE_PERIOD)

    def _view(self):
        now = time.monotonic()
        if now - self._drawn >= DRAWING_PERIOD:
            self._drawn = now
            self._page.draw()
        self._page.move()
