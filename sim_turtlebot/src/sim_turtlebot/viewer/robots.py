"""The robots that there are, and what their topics tell of them."""

import math
import re
import threading
from typing import NamedTuple

import numpy
import rosgraph
import rospy
from nav_msgs.msg import Odometry
from odometry_common.parameters import as_number
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64

from sim_turtlebot.viewer.track import Pose, Track

DEFAULT_TARGET = 90.0  # degrees; what rotate.py turns to unless it is told otherwise
EPOCH = 1e9  # s; stamps beyond this are those of a wall clock


class Graph(NamedTuple):
    """What the ROS master knows."""

    robots: list  # namespaces of the robots, '' or such as 'robot_1/'
    turning: set  # namespaces in which rotate.py runs
    services: set  # full names


class Body(NamedTuple):
    """Where a body is."""

    position: tuple  # x, y, z (m)
    wxyz: tuple  # orientation


class Sight(NamedTuple):
    """All that is to be seen of a robot at a moment; None where nothing tells."""

    body: Body  # the true one if there is one, else the odometry's
    odometry: Body  # in the frame of the odometry
    origin: Pose  # of the odometry
    drift: Pose  # from the odometry to the truth
    wheels: dict  # angles (rad) by joint
    trail: numpy.ndarray  # rows of x, y (m)
    history: numpy.ndarray  # rows as Track.note() takes them
    stamp: float  # s
    simulated_time: float  # s
    moved_distance: float  # m
    true_distance: float  # m
    speed: float  # m/s
    heading: float  # degrees


def look_around():
    """Return the Graph; raise OSError or rosgraph.MasterException if there is no master."""
    publications, subscriptions, services = rosgraph.Master(rospy.get_name()).getSystemState()
    published = {topic for topic, _ in publications}
    subscribed = {topic for topic, nodes in subscriptions if set(nodes) != {rospy.get_name()}}
    namespace = re.escape(rospy.get_namespace())
    numbers = [re.fullmatch(rf'{namespace}robot_(\d+)/odom', topic) for topic in published]
    robots = [f'robot_{number}/' for number in sorted(int(match[1]) for match in numbers if match)]
    if rospy.resolve_name('odom') in published:
        robots.insert(0, '')
    turning = {robot for robot in robots
               if rospy.resolve_name(f'{robot}rotate_robot/target') in subscribed}
    return Graph(robots, turning, {service for service, _ in services})


class Robot:
    """Follows one robot."""

    def __init__(self, namespace):
        """Subscribe to the topics in a namespace, '' or one that ends in a slash."""
        self._target_topic = f'{namespace}rotate_robot/target'
        self._lock = threading.Lock()
        self._track = Track()
        self._odometry = self._truth = self._moved = self._target = None
        self._first_stamp = None
        self._wheels = {}
        topics = [('odom', Odometry, self._on_odometry),
                  ('base_pose_ground_truth', Odometry, self._on_truth),
                  ('joint_states', JointState, self._on_joints),
                  ('moved_distance', Float64, self._on_moved),
                  ('rotate_robot/target', Float64, self._on_target)]
        self._subscribers = [
            rospy.Subscriber(f'{namespace}{topic}', kind, callback, tcp_nodelay=True)
            for topic, kind, callback in topics]

    def close(self):
        """Listen no longer."""
        for subscriber in self._subscribers:
            subscriber.unregister()

    def set_turning(self, turning):
        """Take note whether rotate.py turns this robot: its target then begins as a parameter."""
        if not turning:
            self._target = None
        elif self._target is None:
            target = rospy.get_param(self._target_topic, DEFAULT_TARGET)
            self._target = as_number(target)

    def look(self):
        """Return the Sight, or None if there is none yet."""
        with self._lock:
            if self._odometry is None:
                return None
            track, twist = self._track, self._odometry.twist.twist
            odometry = _body(self._odometry)
            stamp = self._odometry.header.stamp.to_sec()
            simulated = stamp < EPOCH
            track.note(stamp if simulated else stamp - self._first_stamp, self._moved,
                       self._target)
            return Sight(
                body=_body(self._truth) if self._truth else odometry, odometry=odometry,
                origin=track.origin, drift=track.drift, wheels=self._wheels,
                trail=track.trail.array(), history=track.history.array(), stamp=stamp,
                simulated_time=stamp if simulated else None, moved_distance=self._moved,
                true_distance=track.true_distance, speed=twist.linear.x,
                heading=math.degrees(_pose(self._odometry).yaw))

    def _on_odometry(self, message):
        if not _is_usable(message):
            return
        with self._lock:
            stamp = message.header.stamp.to_sec()
            if self._first_stamp is None:
                self._first_stamp = stamp
            self._odometry = message
            self._track.add_odometry(stamp, _pose(message))

    def _on_truth(self, message):
        if not _is_usable(message):
            return
        with self._lock:
            self._truth = message
            self._track.add_truth(message.header.stamp.to_sec(), _pose(message))

    def _on_joints(self, message):
        with self._lock:
            self._wheels = dict(zip(message.name, message.position))

    def _on_moved(self, message):
        self._moved = message.data if math.isfinite(message.data) else None

    def _on_target(self, message):
        if math.isfinite(message.data):
            self._target = message.data


def _body(message):
    position, turn = message.pose.pose.position, message.pose.pose.orientation
    length = math.hypot(turn.w, turn.x, turn.y, turn.z)
    return Body((position.x, position.y, position.z),
                (turn.w / length, turn.x / length, turn.y / length, turn.z / length))


def _pose(message):
    body = _body(message)
    w, x, y, z = body.wxyz
    yaw = math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))
    return Pose(body.position[0], body.position[1], yaw)


def _is_usable(message):
    """Tell whether a pose can be drawn: all of it finite, with an orientation."""
    position, turn = message.pose.pose.position, message.pose.pose.orientation
    length = math.hypot(turn.x, turn.y, turn.z, turn.w)
    numbers = (position.x, position.y, position.z, length, message.twist.twist.linear.x)
    return length > 0 and all(math.isfinite(number) for number in numbers)
