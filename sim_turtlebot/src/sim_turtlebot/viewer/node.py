"""The viewer as a node: what the robots' topics tell goes to the page, while somebody looks."""

import errno
import socket
import time

import rosgraph
import rospkg
import rospy
from odometry_common.node import print_line
from odometry_common.parameters import ParameterError, get_number, get_text
from odometry_common.timing import Metronome

from sim_turtlebot.viewer.model import load_links
from sim_turtlebot.viewer.page import Page
from sim_turtlebot.viewer.robots import Robot, look_around
from sim_turtlebot.viewer.track import RateGauge

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
        self._stopping = False
        rospy.on_shutdown(self._stop)

    def run(self):
        """View until shutdown."""
        while not self._stopping:
            if self._page.is_open:
                self._view()
                time.sleep(FRAME_PERIOD)
            else:
                self._set_robots([])
                self._page.wait()

    def _stop(self):
        self._stopping = True
        self._page.wake()

    def _view(self):
        now = time.monotonic()
        if self._searching.is_due(now):
            self._search()
        sights = {namespace: robot.look() for namespace, robot in self._robots.items()}
        sights = {namespace: sight for namespace, sight in sights.items() if sight}
        self._page.move(sights)
        chosen = sights.get(self._page.chosen)
        rate = self._gauge.rate(now, chosen.stamp) if chosen else None
        if self._drawing.is_due(now):
            self._page.draw(sights, rate)

    def _search(self):
        try:
            graph = look_around()
            if graph.robots:
                # When the last one has gone, its last picture stays.
                self._set_robots(graph.robots)
            for namespace, robot in self._robots.items():
                robot.set_turning(namespace in graph.turning)
        except (OSError, rosgraph.MasterException):
            self._page.simulation.update(set(), 'the ROS master does not answer')
            return
        waiting = '' if graph.robots else f'waiting for odometry on {rospy.resolve_name("odom")}'
        self._page.simulation.update(graph.services, waiting)

    def _set_robots(self, namespaces):
        for namespace in set(self._robots) - set(namespaces):
            self._robots.pop(namespace).close()
        for namespace in namespaces:
            if namespace not in self._robots:
                self._robots[namespace] = Robot(namespace)
        self._page.set_robots(namespaces)


def view():
    """Read the parameters and serve the page until shutdown."""
    port = int(get_number('~port', 8080, lambda v: v == int(v) and 1 <= v <= 65535,
                          'a whole number from 1 to 65535'))
    host = get_text('~host', 'localhost')
    page = Page(_find_address(host, port), port, load_links(_urdf()))
    print_line(f'view: http://{host}:{port}')
    Viewer(page).run()


def _urdf():
    return f'{rospkg.RosPack().get_path("sim_turtlebot")}/urdf/turtlebot2.urdf'


def _find_address(host, port):
    """Return an address of the host that can be listened on; viser would look for another port."""
    try:
        found = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE)
    except OSError:
        raise ParameterError('~host', host, 'a name or an address of this machine') from None
    family, kind, protocol, _, address = min(found)
    with socket.socket(family, kind, protocol) as probe:
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind(address)
        except OSError as error:
            raise _refusal(error, host, port) from None
    return address[0]


def _refusal(error, host, port):
    if error.errno == errno.EADDRNOTAVAIL:
        return ParameterError('~host', host, 'a name or an address of this machine')
    return ParameterError('~port', port, f'a port that can be listened on ({error.strerror})')
