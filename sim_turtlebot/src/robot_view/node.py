"""The viewer as a node: what the robots' topics say goes to the page, while one is open."""

import time

import rosgraph
import rospy
from odometry_common.timing import Metronome
from sim_turtlebot.description import URDF
from std_msgs.msg import String

from robot_view.graph import query_master
from robot_view.model import load_links
from robot_view.page import Page
from robot_view.panel import WARNING
from robot_view.robots import Robot
from robot_view.track import RateGauge

FRAME_PERIOD = 0.05  # s of wall time, between two pictures
DRAWING_PERIOD = 0.2  # s, of trails, figures and plots
SEARCH_PERIOD = 1.0  # s, for robots


class Viewer:
    """Listens to the robots while a page is open, and draws them."""

    def __init__(self, page):
        """Take a Page."""
        self._page = page
        self._robots = {}
        self._searching, self._drawing = Metronome(SEARCH_PERIOD), Metronome(DRAWING_PERIOD)
        self._gauge = RateGauge()
        self._warning = ''
        self._warnings = rospy.Subscriber(WARNING, String, self._on_warning)
        # A shutdown that began earlier calls no hook, but run() notices it.
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
        states = {namespace: robot.state() for namespace, robot in self._robots.items()}
        states = {namespace: state for namespace, state in states.items() if state}
        self._page.move(states)
        chosen = states.get(self._page.chosen)
        rate = self._gauge.rate(now, chosen.stamp) if chosen else None
        if self._drawing.is_due(now):
            self._page.draw(states, rate)

    def _search(self):
        try:
            graph = query_master()
            if graph.robots:
                # When the last one has gone, its last picture stays.
                self._set_robots(graph.robots)
            for namespace, robot in self._robots.items():
                robot.set_rotating(namespace in graph.rotating)
        except (OSError, rosgraph.MasterException):
            self._page.update_simulation(set(), 'the ROS master does not answer')
            return
        complaint = self._warning if self._warnings.get_num_connections() else ''
        if not graph.robots:
            complaint = f'waiting for odometry on {rospy.resolve_name("odom")}'
        self._page.update_simulation(graph.services, complaint)

    def _on_warning(self, message):
        self._warning = message.data

    def _set_robots(self, namespaces):
        for namespace in set(self._robots) - set(namespaces):
            self._robots.pop(namespace).close()
        for namespace in namespaces:
            if namespace not in self._robots:
                self._robots[namespace] = Robot(namespace)
        self._page.set_robots(namespaces)


def view(address):
    """Serve the page at an Address until shutdown."""
    viewer = Viewer(Page(address, load_links(URDF)))
    print(f'view: {address.url}')
    viewer.run()
