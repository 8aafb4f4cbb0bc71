"""A session that the check uses for one scenario after another."""

import contextlib
import logging
import math
from functools import partial
from typing import NamedTuple

import rosgraph
import rospy
from geometry_msgs.msg import PoseStamped, Twist
from moved_distance.distance_counter import DistanceCounter
from odometry_common.connections import SENDS, ask, is_connected
from odometry_common.publishing import advertise
from sim_turtlebot.geometry import about_z
from std_msgs.msg import Empty, Float64

from odometry_tools.runs.recording import COMMANDS, TOPICS
from odometry_tools.runs.session import Session
from odometry_tools.runs.starting import registered

PAGE = '/session_view'
FLOOD = 20  # commands queued; older ones are dropped
NEAR = 0.01  # m
CPU_BUDGET = 2.0  # s; a tutorial's node computes for milliseconds


class Pace(NamedTuple):
    """How simulated time goes on."""

    lockstep: bool = True
    real_time_factor: float = 0.0  # 0: as fast as the machine can


class CheckSession(Session):
    """A Session in which the check plays the part that the node does not.

    For an exercise with a route it drives the robot; for others it publishes the distance.
    """

    def __init__(self, exercise, page_port=0):
        """Take an Exercise, and the port of a browser page (0: none)."""
        super().__init__(page_port)
        self.exercise = exercise
        self._drives = bool(exercise.route)
        self._position = math.inf, math.inf
        self.run = None  # the Run that receives the messages

    def __enter__(self):
        """Start the master, and register as a node."""
        super().__enter__()
        logging.getLogger('rosout').setLevel(logging.ERROR)  # the verdict tells of wrong types
        # roslaunch starts /rosout.
        self.ours = {rospy.get_name(), '/sim_turtlebot', PAGE, '/rosout'}
        self._subscribers = {topic: rospy.Subscriber(
            topic, kind, partial(self._receive, topic), tcp_nodelay=True,
            queue_size=FLOOD if kind is Twist else None) for topic, kind in TOPICS.items()}
        self._placing = advertise('sim_turtlebot/set_pose', PoseStamped)
        if self._drives:
            self._publisher = advertise('cmd_vel', Twist)
        else:
            self._publisher = advertise('moved_distance', Float64)
            rospy.Subscriber('moved_distance/reset', Empty, lambda _: self._counter.reset())
        return self

    def prepare(self, scenario, pace):
        """Reset the paused simulation and place the robot for a Scenario at a Pace."""
        self.simulate({'odom_rate': scenario.odom_rate, 'speed_ratio': scenario.speed_ratio,
                       'cpu_budget': CPU_BUDGET, **pace._asdict()})
        self.simulator.wait_for(self._is_connected, 'the simulator does not answer')
        self.call('reset_simulation')
        self._place(*scenario.place, scenario.yaw)
        self._counter = DistanceCounter()

    def drive(self, linear, angular):
        """Command a velocity (m/s, rad/s)."""
        command = Twist()
        command.linear.x, command.angular.z = linear, angular
        self._publisher.publish(command)

    def record_graph(self, run):
        """Record the nodes and topics that the master knows in the Run."""
        publishers, subscribers, _ = self.master.getSystemState()
        for topics, found in (publishers, run.publishes), (subscribers, run.subscribes):
            for topic, names in topics:
                if {*names} - self.ours:
                    found.setdefault(topic, '')
                    run.nodes |= {*names} - self.ours

    def ask_for_types(self, run):
        """Ask the nodes for the types of their topics: the master keeps only one type a topic."""
        for name in run.nodes:
            run.publishes.update(self.ask(name, 'getPublications') or ())
            run.subscribes.update(self.ask(name, 'getSubscriptions') or ())

    def links(self, topic):
        """Return the connections by which nodes send us a topic: address and number at the node."""
        return {(connection.endpoint_id, number)
                for connection in self._subscribers[topic.lstrip('/')].impl.connections
                for number, receiver, direction, _, sent, *_
                in ask(connection.endpoint_id, 'getBusInfo') or ()
                if (receiver, direction, sent) == (rospy.get_name(), SENDS, topic)}

    def is_refused(self, links, topic):
        """Return whether a node has closed one of these connections for a topic, and lives."""
        closed = links - self.links(topic)
        return any(ask(uri, 'getPid') for uri, _ in closed)

    def ask(self, name, call='getPid'):
        """Call a node's XML-RPC server; return its answer, or None without one."""
        with contextlib.suppress(rosgraph.MasterException):
            return ask(self.master.lookupNode(name), call)

    def has_left(self, names):
        """Return whether all of these nodes (at least one) have unregistered."""
        return bool(names) and names.isdisjoint(f'/{name}' for name in registered())

    def is_silent(self):
        """Return whether no other node is connected to a command topic."""
        return not any(self._subscribers[topic].impl.connections for topic in COMMANDS)

    def _is_connected(self):
        return (self._placing.get_num_connections() and is_connected(self._subscribers['odom'])
                and (not self._drives or self._publisher.get_num_connections()))

    def _place(self, x, y, yaw):
        pose = PoseStamped()
        pose.pose.position.x, pose.pose.position.y = x, y
        orientation = pose.pose.orientation
        orientation.x, orientation.y, orientation.z, orientation.w = about_z(math.radians(yaw))
        self._placing.publish(pose)
        self.simulator.wait_for(lambda: math.dist(self._position, (x, y)) < NEAR,
                                'the robot is not put in its place')

    def _receive(self, topic, message):
        if topic == 'odom':
            self._position = message.pose.pose.position.x, message.pose.pose.position.y
        if self.run:
            self.run.add(topic, message)
            if topic == 'odom' and not self._drives:
                self._counter.add(*self._position, *2 * [message.header.stamp.to_sec()])
                self._publisher.publish(self._counter.distance)
