"""The robots on the master, recorded from the moment at which they appear."""

import re
import threading

import rosgraph
import rospy
from odometry_common.connections import NO_ANSWER
from std_msgs.msg import String

from robot_view.monitor import SIMULATOR, RobotMonitor

SERVICES = {'pause': f'{SIMULATOR}/pause_physics', 'resume': f'{SIMULATOR}/unpause_physics',
            'reset': f'{SIMULATOR}/reset_simulation'}
FIRST_PERIOD = 0.1  # s between two searches, until there is a robot: it may drive at once
SEARCH_PERIOD = 1.0  # s


class Robots:
    """Searches for robots on a thread, and records them even without a browser."""

    def __init__(self, **targets):
        """Search; targets are those of a RobotMonitor."""
        self._targets = targets
        self.monitors = {}  # RobotMonitor by namespace: '' or such as 'robot_1/'
        self.is_simulated = False
        self.complaint = ''  # for the status line
        self._warning = ''
        self.found = threading.Event()  # set with the first robot, or at shutdown
        rospy.on_shutdown(self.found.set)
        self._warnings = rospy.Subscriber(f'{SIMULATOR}/warning', String, self._on_warning)
        threading.Thread(target=self._search_until_shutdown, daemon=True).start()

    def _search_until_shutdown(self):
        pause = threading.Event()  # lockstep would warn of a node that only calls time.sleep()
        while not rospy.core.is_shutdown_requested():
            self._search()
            pause.wait(SEARCH_PERIOD if self.monitors else FIRST_PERIOD)

    def _search(self):
        """Record the robots that are there; if there are none, keep the last ones."""
        try:
            publications, _, services = rosgraph.Master(rospy.get_name()).getSystemState()
            if found := find_robots({topic for topic, _ in publications}):
                self._record(found)
                self.complaint = self._warning if self._warnings.get_num_connections() else ''
            else:
                self.complaint = f'waiting for odometry on {rospy.resolve_name("odom")}'
        except (*NO_ANSWER, rosgraph.MasterException):
            self.is_simulated, self.complaint = False, 'the ROS master does not answer'
            return
        names = {service for service, _ in services}
        self.is_simulated = names.issuperset(map(rospy.resolve_name, SERVICES.values()))

    def _record(self, found):
        before = self.monitors
        self.monitors = {robot: before.get(robot) or RobotMonitor(robot, **self._targets)
                         for robot in found}
        self.found.set()
        for robot in before.keys() - self.monitors.keys():
            before[robot].close()

    def _on_warning(self, message):
        self._warning = message.data


def find_robots(topics):
    """Return the namespaces of the robots that publish odometry: '' or such as 'robot_1/'."""
    namespace = re.escape(rospy.get_namespace())
    numbers = [re.fullmatch(rf'{namespace}robot_(\d+)/odom', topic) for topic in topics]
    robots = [f'robot_{number}/'
              for number in sorted((match[1] for match in numbers if match), key=int)]
    return ['', *robots] if rospy.resolve_name('odom') in topics else robots
