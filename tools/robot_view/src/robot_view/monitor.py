"""The state of a robot, from its topics."""

import math
import threading
import time
from collections import deque
from typing import NamedTuple

import numpy
import rospy
from geometry_msgs.msg import Point, Pose, PoseStamped, Quaternion
from nav_msgs.msg import Odometry
from sensor_msgs.msg import JointState, LaserScan
from sim_turtlebot.frames import read_pose
from sim_turtlebot.geometry import PlanarPose, about_z, yaw_of
from sim_turtlebot.kobuki import DEPTH_CAMERA, DEPTH_CAMERA_FRAME
from std_msgs.msg import Empty, Float64

from robot_view.path_trace import PathTrace

SIMULATOR = 'sim_turtlebot'  # node
LONGEST_LAG = 1.0  # s between odometry and ground truth of one robot
EPOCH = 1e9  # s; stamps beyond this are wall time
RATE_SAMPLES = 10  # readings at most per measurement of the real-time factor


class State(NamedTuple):
    """What an Odometry message says."""

    stamp: float  # s
    pose: tuple  # x, y, z (m) and a quaternion x, y, z, w of length 1
    planar: PlanarPose
    speed: float  # m/s, forwards


class RobotMonitor:
    """The latest state of one robot: once there is an `odometry`, hold the `lock` to read it.

    Its distance_target (m, ahead of the odometry's origin) and heading_target (degrees) are None if
    unknown. The namespace is '' or ends in a slash.
    """

    def __init__(self, namespace, distance_target=None, heading_target=None):
        self.namespace, self.name = namespace, namespace.strip('/')
        self.lock = threading.Lock()
        self.trace = PathTrace()
        self.wheels = {}  # angles (rad) by joint
        self.scan = None  # State of the robot, and points in its frame: rows of x, y, z (m)
        self.distance_target, self.heading_target = distance_target, heading_target
        self.odometry = None  # State
        self.moved = None  # m, as the detector counts it
        self._ground_truth = None
        self._clocks = deque(maxlen=RATE_SAMPLES)  # real and simulated time (s)
        self._real_time_factor = None
        self._poses = rospy.Publisher(f'{SIMULATOR}/{namespace}set_pose', PoseStamped, queue_size=1)
        self._reset = rospy.Publisher(f'{namespace}moved_distance/reset', Empty, queue_size=1)
        topics = [('odom', Odometry, self._on_odometry),
                  ('joint_states', JointState, self._on_joints),
                  ('moved_distance', Float64, self._on_moved),
                  ('scan', LaserScan, self._on_scan),
                  ('rotate_robot/target', Float64, self._on_target)]
        self._truths = rospy.Subscriber(f'{namespace}base_pose_ground_truth', Odometry,
                                        self._on_ground_truth, tcp_nodelay=True)
        self._connections = [self._poses, self._reset, self._truths, *(
            rospy.Subscriber(f'{namespace}{topic}', kind, callback, tcp_nodelay=True)
            for topic, kind, callback in topics)]

    def close(self):
        """Disconnect from the robot."""
        for connection in self._connections:
            connection.unregister()

    def reset_distance(self):
        """Let the detector start counting from zero."""
        self.moved = None  # until it says so
        self._reset.publish()

    def put(self, x, y, heading):
        """Place a simulated robot in the world, at x, y (m) and a heading (degrees), at rest."""
        orientation = Quaternion(*about_z(math.radians(heading)))
        self._poses.publish(pose=Pose(Point(x, y, 0.0), orientation))

    @property
    def state(self):
        """The true State if the robot is simulated, else the odometry's."""
        return self._ground_truth or self.odometry

    def places(self):
        """Return x, y (m) of the robot, of its start, along the path, and of the goal if any."""
        start = self.trace.origin
        places = [self.state.planar[:2], start[:2], *self.trace.trail.array()]
        if self.distance_target is not None:
            places.append(start.then(PlanarPose(self.distance_target, 0.0, 0.0))[:2])
        return places

    @property
    def simulated_time(self):
        """The time of the odometry (s); None if that is wall time."""
        return self.odometry.stamp if self.odometry.stamp < EPOCH else None

    def real_time_factor(self):
        """Return the robot's seconds per second; None until it is known."""
        if self._clocks and self.odometry.stamp < self._clocks[-1][1]:  # after a reset
            self._clocks.clear()
        self._clocks.append((time.monotonic(), self.odometry.stamp))
        (start, first), (end, last) = self._clocks[0], self._clocks[-1]
        if len(self._clocks) > 1:
            self._real_time_factor = (last - first) / (end - start)
        return self._real_time_factor

    def _on_odometry(self, message):
        with self.lock:
            state = _state_in(message)
            if state is None:
                return
            if self._is_another(state):
                self._ground_truth, self.trace = None, PathTrace()
            self.odometry = state
            self.trace.add_odometry(state.stamp, state.planar)
            self.trace.add_history(self.moved, self.heading_target)

    def _is_another(self, state):
        """Return whether this State is of a real robot, which has followed the simulator's."""
        truth = self._ground_truth
        return (truth is not None and abs(state.stamp - truth.stamp) > LONGEST_LAG
                and not self._truths.get_num_connections())

    def _on_ground_truth(self, message):
        with self.lock:
            state = _state_in(message)
            if state is not None:
                self._ground_truth = state
                self.trace.add_ground_truth(state.stamp, state.planar)

    def _on_joints(self, message):
        with self.lock:
            self.wheels = {name: angle for name, angle in zip(message.name, message.position)
                           if math.isfinite(angle)}

    def _on_scan(self, message):
        points = scan_points(message)
        with self.lock:
            if self.odometry:
                self.scan = self.state, points

    def _on_moved(self, message):
        self.moved = message.data if math.isfinite(message.data) else None

    def _on_target(self, message):
        if math.isfinite(message.data):
            self.heading_target = message.data


def _state_in(message):
    """Return the State in an Odometry; None if it cannot be drawn."""
    position, rotation = read_pose(message.pose.pose)
    speed = message.twist.twist.linear.x
    length = numpy.linalg.norm(rotation)
    if not length or not numpy.isfinite([*position, length, speed]).all():
        return None
    rotation = rotation / length
    planar = PlanarPose(*position[:2], yaw_of(rotation))
    return State(message.header.stamp.to_sec(), (position, rotation), planar, speed)


def scan_points(message):
    """Return the points of a LaserScan: rows of x, y, z (m) in the frame of the base.

    Ranges that are infinite or NaN, as in REP-117, give no point. Nor does a sensor other than the
    depth camera, since its place on the robot is unknown.
    """
    if message.header.frame_id.split('/')[-1] != DEPTH_CAMERA_FRAME:
        return numpy.empty((0, 3))
    ranges = numpy.array(message.ranges, dtype=float)
    with numpy.errstate(invalid='ignore'):  # of any numbers in the message
        angles = message.angle_min + message.angle_increment * numpy.arange(len(ranges))
        is_seen = (ranges >= message.range_min) & (ranges <= message.range_max)
        points = numpy.column_stack([
            ranges * numpy.cos(angles),
            ranges * numpy.sin(angles),
            numpy.zeros(len(ranges))])
    return points[is_seen & numpy.isfinite(points).all(axis=1)] + DEPTH_CAMERA
