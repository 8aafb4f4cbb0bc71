"""The viewer as a node: it draws the robots' topics on the page while a browser shows it."""

import time
from collections import deque

import rosgraph
import rospy
from odometry_common.timing import Metronome
from sim_turtlebot.description import URDF
from std_msgs.msg import String

from robot_view.browser_page import BrowserPage
from robot_view.discovery import discover
from robot_view.looks import load_links
from robot_view.monitor import RobotMonitor
from robot_view.panel import NODE, SERVICES

FRAME_PERIOD = 0.05  # s of wall time, between two pictures
DRAWING_PERIOD = 0.2  # s, of trails, readings and plots
SEARCH_PERIOD = 1.0  # s, for robots
RATE_SAMPLES = 10  # drawings, over which the real-time factor is measured


class Viewer:
    """Subscribes to the robots while a browser shows the page, and draws them."""

    def __init__(self, page):
        """Take a BrowserPage."""
        self._page = page
        self._robots = {}  # monitors by namespace
        self._searching, self._drawing = Metronome(SEARCH_PERIOD), Metronome(DRAWING_PERIOD)
        self._clocks = deque(maxlen=RATE_SAMPLES)  # real and simulated time (s)
        self._warning = ''
        self._warnings = rospy.Subscriber(f'{NODE}/warning', String, self._on_warning)
        # rospy calls no hook for a shutdown that is already under way; run() checks for that.
        rospy.on_shutdown(page.wake)

    def run(self):
        """View until shutdown."""
        while not rospy.core.is_shutdown_requested():
            if self._page.is_open:
                self._view()
                time.sleep(FRAME_PERIOD)
            else:
                self._set_robots([])
                self._page.wait()

    def _view(self):
        now = time.monotonic()
        if self._searching.is_due(now):
            self._search()
        robots = {namespace: robot for namespace, robot in self._robots.items() if robot.is_known}
        self._page.move(robots)
        if self._drawing.is_due(now):
            self._page.draw(robots, self._real_time_factor(now, robots.get(self._page.chosen)))

    def _real_time_factor(self, now, robot):
        """Return the robot's seconds per second; None until it is known, and after a reset."""
        if robot is None:
            return None
        self._clocks.append((now, robot.stamp))
        (start, first), (end, last) = self._clocks[0], self._clocks[-1]
        is_full = len(self._clocks) == self._clocks.maxlen
        return (last - first) / (end - start) if is_full and last >= first else None

    def _search(self):
        try:
            found = discover()
            for namespace, robot in self._robots.items():
                robot.set_rotating(namespace in found.rotating)
        except (OSError, rosgraph.MasterException):
            self._page.update_simulation(False, 'the ROS master does not answer')
            return
        complaint = self._warning if self._warnings.get_num_connections() else ''
        if found.robots:
            self._set_robots(found.robots)
        else:  # the last picture stays
            complaint = f'waiting for odometry on {rospy.resolve_name("odom")}'
        is_simulated = found.services.issuperset(map(rospy.resolve_name, SERVICES.values()))
        self._page.update_simulation(is_simulated, complaint)

    def _on_warning(self, message):
        self._warning = message.data

    def _set_robots(self, namespaces):
        for namespace in set(self._robots) - set(namespaces):
            self._robots.pop(namespace).close()
        for namespace in namespaces:
            if namespace not in self._robots:
                self._robots[namespace] = RobotMonitor(namespace)
        self._page.set_robots(namespaces)


def view(address):
    """Serve the page at an Address until shutdown."""
    viewer = Viewer(BrowserPage(address, load_links(URDF)))
    print(f'view: {address.url}')
    viewer.run()
