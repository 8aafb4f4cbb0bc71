"""The viewer node: it finds robots, and draws them on the page while a browser shows it."""

import re
import threading
import time

import rosgraph
import rospy
from std_msgs.msg import String

from robot_view.browser_page import BrowserPage
from robot_view.monitor import TARGET
from robot_view.panel import NODE, SERVICES

FRAME_PERIOD = 0.05  # s of wall time between two pictures
DRAWING_PERIOD = 0.2  # s between two updates of trails, readings and plots
SEARCH_PERIOD = 1.0  # s between two searches for robots
IDLE_PERIOD = 0.5  # s between two checks for a browser


class Viewer:
    """Subscribes to the robots while a browser shows the page, and draws them."""

    def __init__(self, address):
        self._page = BrowserPage(address)
        self._searched = self._drawn = 0.0  # time of the last search and drawing (s)
        self._warning = ''
        self._warnings = rospy.Subscriber(f'{NODE}/warning', String, self._on_warning)

    def run(self):
        """View until shutdown."""
        pause = threading.Event()  # lockstep would warn of a node that only calls time.sleep()
        while not rospy.core.is_shutdown_requested():
            if self._page.is_open:
                self._view()
                time.sleep(FRAME_PERIOD)
            else:
                self._page.set_robots([])
                pause.wait(IDLE_PERIOD)

    def _view(self):
        now = time.monotonic()
        if now - self._searched >= SEARCH_PERIOD:
            self._searched = now
            self._search()
        self._page.move()
        if now - self._drawn >= DRAWING_PERIOD:
            self._drawn = now
            self._page.draw()

    def _search(self):
        try:
            publications, subscriptions, services = (
                rosgraph.Master(rospy.get_name()).getSystemState())
            subscribed = {topic for topic, nodes in subscriptions
                          if set(nodes) != {rospy.get_name()}}
            self._page.set_rotating(lambda robot: rospy.resolve_name(robot + TARGET) in subscribed)
        except (OSError, rosgraph.MasterException):
            self._page.update_simulation(False, 'the ROS master does not answer')
            return
        complaint = self._warning if self._warnings.get_num_connections() else ''
        robots = find_robots({topic for topic, _ in publications})
        if robots:
            self._page.set_robots(robots)
        else:  # keep the last picture
            complaint = f'waiting for odometry on {rospy.resolve_name("odom")}'
        names = {service for service, _ in services}
        is_simulated = names.issuperset(map(rospy.resolve_name, SERVICES.values()))
        self._page.update_simulation(is_simulated, complaint)

    def _on_warning(self, message):
        self._warning = message.data


def find_robots(topics):
    """Return the namespaces of the robots that publish odometry: '' or such as 'robot_1/'."""
    namespace = re.escape(rospy.get_namespace())
    numbers = [re.fullmatch(rf'{namespace}robot_(\d+)/odom', topic) for topic in topics]
    robots = [f'robot_{number}/' for number in sorted(int(match[1]) for match in numbers if match)]
    return ['', *robots] if rospy.resolve_name('odom') in topics else robots
