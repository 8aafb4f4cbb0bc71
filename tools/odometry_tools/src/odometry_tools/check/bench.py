"""A master, the simulator and this process as a node, in which scenarios can be repeated."""

import contextlib
import math
import sys
from functools import partial
from typing import NamedTuple

import rosgraph
import rospy
from geometry_msgs.msg import PoseStamped, Twist
from moved_distance.distance_counter import DistanceCounter
from nav_msgs.msg import Odometry
from odometry_common.connections import ask, is_connected
from odometry_common.publishing import advertise
from rosgraph_msgs.msg import Log
from roslib.packages import find_node
from sim_turtlebot.geometry import about_z
from std_msgs.msg import Float64
from std_srvs.srv import Empty

from odometry_tools.check.processes import Started
from odometry_tools.check.quoting import last_line
from odometry_tools.runs.following import is_answered, join
from odometry_tools.runs.launch import Launch
from odometry_tools.runs.output import RunError
from odometry_tools.runs.recording import COMMANDS

KINDS = {'odom': Odometry, 'base_pose_ground_truth': Odometry, 'moved_distance': Float64,
         **dict.fromkeys(COMMANDS, Twist)}
OURS = {'/sim_turtlebot', '/check_view', '/rosout'}  # roslaunch starts the last
FLOOD = 20  # commands that arrive together; of more, the latest
NEAR = 0.01  # m
CPU_BUDGET = 2.0  # s; a tutorial's node computes for milliseconds
SIMULATOR = 'sim_turtlebot'
SERVICES = 'pause_physics', 'unpause_physics', 'reset_simulation'


class Pace(NamedTuple):
    """How simulated time goes on."""

    lockstep: bool = True
    real_time_factor: float = 0.0  # 0: as fast as the machine can


class Bench:
    """A context with a simulator that is always paused, but for what its user does."""

    def __init__(self, exercise, page_port=0):
        """Take an Exercise, and where a page is served, if one is."""
        self._launch = Launch('odometry_tools', 'check.launch', {'page_port': page_port})
        self._drives = bool(exercise.route)
        self._simulator = self._settings = self._position = None
        self.run = None  # which takes the messages

    def __enter__(self):
        """Start the master, and become a node."""
        with contextlib.redirect_stdout(sys.stderr):  # the master's port is no part of the report
            self._launch.__enter__()
        try:
            join(self._launch, 'check')
        except BaseException:
            self._launch.__exit__()
            raise
        self.master = rosgraph.Master(rospy.get_name())
        self._subscribers = {topic: rospy.Subscriber(
            topic, kind, partial(self._receive, topic), tcp_nodelay=True,
            queue_size=FLOOD if kind is Twist else None) for topic, kind in KINDS.items()}
        rospy.Subscriber('/rosout', Log, self._read_log, tcp_nodelay=True)
        self._placing = advertise('sim_turtlebot/set_pose', PoseStamped)
        # The check does what the learner's node does not: it drives, or measures the distance.
        self._publisher = advertise('cmd_vel', Twist) if self._drives else advertise('moved_distance', Float64)
        return self

    def __exit__(self, *_):
        """End everything."""
        if self._simulator:
            self._simulator.end()
        self._launch.__exit__()

    def prepare(self, scenario, pace):
        """Put the robot where a Scenario begins, at a Pace, with time standing still."""
        settings = {'odom_rate': scenario.odom_rate, 'speed_ratio': scenario.speed_ratio, **pace._asdict()}
        if settings != self._settings:
            self._simulate(settings)
        self.call('reset_simulation')
        self._place(*scenario.place, scenario.yaw)
        self._counter = DistanceCounter()

    def call(self, service):
        """Have the simulator pause, unpause or reset; beside other work it may miss a call."""
        self.wait_for(lambda: self._is_alive() and is_answered(self._services[service]),
                      'the simulator does not answer')

    def drive(self, linear, angular):
        """Command a velocity (m/s, rad/s)."""
        command = Twist()
        command.linear.x, command.angular.z = linear, angular
        self._publisher.publish(command)

    def check(self):
        """Raise RunError if the simulator has ended, KeyboardInterrupt after a signal."""
        self._launch.check()
        self._is_alive()

    def _is_alive(self):
        """Return True, or raise RunError: on a thread of wait_for() a signal is not looked at."""
        if self._simulator and self._simulator.status is not None:
            raise RunError(f'the simulator has ended: {last_line(self._simulator.output) or "without a word"}')
        return True

    def wait_for(self, condition, complaint):
        """Return once a condition holds, which is looked at again and again."""
        self._launch.wait_for(condition, complaint)

    def has_spectator(self):
        """Return whether a browser shows the page."""
        _, subscribers, _ = self.master.getSystemState()
        return any(topic == '/odom' and '/check_view' in names for topic, names in subscribers)

    def is_refused(self, topic):
        """Return whether a node that answers publishes a topic that this subscribes to, and nothing connects."""
        publishers, _, _ = self.master.getSystemState()
        names = {name for known, names in publishers if known == topic for name in names} - {rospy.get_name()}
        return any(map(self.ask, names)) and not is_connected(self._subscribers[topic.lstrip('/')])

    def ask(self, name, call='getPid'):
        """Return what a node answers to a call; None if it does not."""
        with contextlib.suppress(rosgraph.MasterException):
            return ask(self.master.lookupNode(name), call)

    def has_left(self):
        """Return whether no other node is connected to what drives the robot."""
        return not any(self._subscribers[topic].impl.connections for topic in COMMANDS)

    def _simulate(self, settings):
        """Start a simulator, and its time, which then stands still."""
        if self._simulator:
            self._simulator.end()
        path = find_node(SIMULATOR, 'sim_turtlebot_node.py')[0]
        self._settings, self._position = settings, None
        self._simulator = Started([path, '_paused:=true', f'_cpu_budget:={CPU_BUDGET}', *(
            f'_{name}:={str(value).lower()}' for name, value in settings.items())])
        self.wait_for(self._is_ready, 'the simulator does not start')
        self._services = {name: rospy.ServiceProxy(f'{SIMULATOR}/{name}', Empty, persistent=True)
                          for name in SERVICES}
        self.call('unpause_physics')
        self.wait_for(lambda: self._position, 'no odometry comes from the simulator')
        self.call('pause_physics')

    def _is_ready(self):
        self._is_alive()
        self.master.lookupService(f'/{SIMULATOR}/pause_physics')
        return (self._placing.get_num_connections() and is_connected(self._subscribers['odom'])
                and (not self._drives or self._publisher.get_num_connections()))

    def _place(self, x, y, yaw):
        pose = PoseStamped()
        pose.pose.position.x, pose.pose.position.y = x, y
        orientation = pose.pose.orientation
        orientation.x, orientation.y, orientation.z, orientation.w = about_z(math.radians(yaw))
        self._placing.publish(pose)
        self.wait_for(lambda: math.dist(self._position, (x, y)) < NEAR, 'the robot is not put in its place')

    def _receive(self, topic, message):
        if topic == 'odom':
            self._position = message.pose.pose.position.x, message.pose.pose.position.y
        if self.run:
            self.run.add(topic, message)
            if topic == 'odom' and not self._drives:
                self._counter.add(*self._position, *2 * [message.header.stamp.to_sec()])
                self._publisher.publish(self._counter.distance)

    def _read_log(self, message):
        if self.run and message.name == '/sim_turtlebot':
            self.run.note_log(message.msg, OURS | {rospy.get_name()})
