"""The ROS master and the nodes of the soak, and what connects them with it."""

import contextlib
import os
import queue

import rosgraph
import rospy
from checks import Violation
from course import RATE
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from odometry_common.publishing import advertise
from odometry_tests.links import links
from odometry_tests.pausing import call
from odometry_tests.processes import Master, rosrun
from odometry_tests.tutorial import detector, simulator_in_step
from odometry_tests.waiting import PATIENCE, wait_for_subscribers, wait_until
from std_msgs.msg import Empty, Float64

NAME = '/soak'
DETECTOR = '/detector'
SIMULATOR = '/sim_turtlebot'
START_TIMEOUT = 30.0  # s
SILENCE = 30.0  # s of wall time without a message that must come
PAUSE_LOOK = 0.05  # s of wall time to see that nothing moves


class Stream:
    """The messages on a topic, one after the other."""

    def __init__(self, topic, message_class):
        self._topic = topic
        self._messages = queue.Queue()
        rospy.Subscriber(topic, message_class, self._messages.put, tcp_nodelay=True)

    def next(self, timeout=SILENCE):
        """Return the next message, or raise Violation if there is none."""
        try:
            return self._messages.get(timeout=timeout)
        except queue.Empty:
            raise Violation(f'nothing comes on {self._topic} for {timeout:g} s') from None

    def check_silence(self):
        """Raise Violation if a message comes now."""
        try:
            message = self._messages.get(timeout=PAUSE_LOOK)
        except queue.Empty:
            return
        raise Violation(f'{self._topic} goes on during a pause, with number {message.header.seq}')


class Nodes:
    """A context in which the simulator and the detector run, and this process is a node."""

    def __init__(self):
        self._master = self._log = self._simulator = self._detector = None

    def __enter__(self):
        """Start everything; simulated time stands still until unpause()."""
        try:
            self._master = Master(use_sim_time=True)
            self._log = rosrun('odometry_launch', 'rosout.py')
            rospy.init_node(NAME[1:], disable_signals=True, disable_rostime=True)
            self._connect()
            self._start_simulator()
            self._start_detector()
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        rospy.signal_shutdown('the soak has ended')
        for process in (self._detector, self._simulator, self._log, self._master):
            if process is not None:
                process.__exit__()

    @property
    def pids(self):
        """Process ids by name."""
        return {'simulator': self._simulator.pid, 'detector': self._detector.pid,
                'rosmaster': self._master.pid, 'rosout': self._log.pid, 'this program': os.getpid()}

    def command(self, linear, angular):
        command = Twist()
        command.linear.x, command.angular.z = linear, angular
        self._velocity.publish(command)

    def restart_detector(self, signum):
        """End the detector by a signal and start another, while the simulation is paused."""
        self._detector.end(signum)
        self._start_detector()

    def _connect(self):
        self.odometry = Stream('odom', Odometry)
        self.truth = Stream('base_pose_ground_truth', Odometry)
        self.distance = Stream('moved_distance', Float64)
        self._velocity = advertise('cmd_vel', Twist)
        self.reset_distance, self.reset_odometry = (
            advertise(topic, Empty) for topic in ('moved_distance/reset',
                                                  'mobile_base/commands/reset_odometry'))

    def _start_simulator(self):
        """Start the simulator, paused, and return once its topics are connected."""
        self._simulator = simulator_in_step(f'_odom_rate:={RATE}', '_real_time_factor:=0',
                                            '_paused:=true')
        # The last of its services.
        rospy.wait_for_service(f'{SIMULATOR}/reset_simulation', START_TIMEOUT * PATIENCE)
        for publisher in self._velocity, self.reset_odometry:
            wait_for_subscribers(publisher, timeout=START_TIMEOUT)
        self._wait_for_links(SIMULATOR, {('/odom', NAME), ('/base_pose_ground_truth', NAME)})

    def _start_detector(self):
        """Start a detector and return once its topics are connected."""
        stale = links(SIMULATOR) | links(NAME)
        self._detector = detector(f'__name:={DETECTOR[1:]}')
        self._wait_for_links(DETECTOR, {('/moved_distance', NAME)})
        self._wait_for_links(NAME, {('/moved_distance/reset', DETECTOR)}, stale)
        self._wait_for_links(SIMULATOR, {('/odom', DETECTOR)}, stale)

    @staticmethod
    def call(name):
        """Call a service of the simulator and return once it is done."""
        try:
            call(name)
        except rospy.ServiceException as error:
            raise Violation(f'the simulator does not answer to {name}: {error}') from None

    @staticmethod
    def _wait_for_links(node, wanted, stale=frozenset()):
        """Return once a node sends to others, by (topic, node), over links that are not stale."""
        def are_there():
            with contextlib.suppress(rosgraph.MasterError, OSError):  # until the node answers
                return wanted <= {link[:2] for link in links(node) - stale}

        wait_until(are_there, START_TIMEOUT, f'{wanted} from {node}')
