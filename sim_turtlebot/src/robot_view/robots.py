"""What the topics of a robot say about it."""

import math
import threading
from typing import NamedTuple

import numpy
import rospy
from nav_msgs.msg import Odometry
from odometry_common.geometry import PlanarPose, planar_pose, yaw_from_orientation
from odometry_common.parameters import as_number
from sensor_msgs.msg import JointState, LaserScan
from std_msgs.msg import Float64

from robot_view.graph import TARGET
from robot_view.scan import Scan, scan_points
from robot_view.track import Track

EPOCH = 1e9  # s; stamps beyond this are those of a wall clock


class Pose3D(NamedTuple):
    """A pose as viser takes it."""

    position: tuple  # x, y, z (m)
    wxyz: tuple  # orientation


class RobotState(NamedTuple):
    """All that is known of a robot at one moment; None where nothing is known."""

    pose: Pose3D  # ground truth if there is one, else the odometry's
    odometry: Pose3D  # in the frame of the odometry
    origin: PlanarPose  # of the odometry
    drift: PlanarPose  # from the odometry to the ground truth
    wheels: dict  # angles (rad) by joint
    scan: Scan
    trail: numpy.ndarray  # rows of x, y (m)
    history: numpy.ndarray  # rows as Track.note() takes them
    stamp: float  # s
    simulated_time: float  # s
    moved_distance: float  # m
    true_distance: float  # m
    speed: float  # m/s
    heading: float  # degrees


class Robot:
    """Follows one robot."""

    def __init__(self, namespace):
        """Subscribe to the topics in a namespace, '' or one that ends in a slash."""
        self._target_topic = f'{namespace}{TARGET}'
        self._lock = threading.Lock()
        self._track = Track()
        self._odometry = self._ground_truth = self._moved = self._target = None
        self._first_stamp = None
        self._wheels = {}
        self._scan = None
        topics = [('odom', Odometry, self._on_odometry),
                  ('base_pose_ground_truth', Odometry, self._on_ground_truth),
                  ('joint_states', JointState, self._on_joints),
                  ('moved_distance', Float64, self._on_moved),
                  ('scan', LaserScan, self._on_scan),
                  (TARGET, Float64, self._on_target)]
        self._subscribers = [
            rospy.Subscriber(f'{namespace}{topic}', kind, callback, tcp_nodelay=True)
            for topic, kind, callback in topics]

    def close(self):
        """Unsubscribe."""
        for subscriber in self._subscribers:
            subscriber.unregister()

    def set_rotating(self, rotating):
        """Note whether rotate.py turns this robot: its parameter, if set, is the first target."""
        if not rotating:
            self._target = None
        elif self._target is None:
            self._target = as_number(rospy.get_param(self._target_topic, None))

    def state(self):
        """Return the RobotState, or None before the first odometry."""
        with self._lock:
            if self._odometry is None:
                return None
            track = self._track
            odometry = _pose_3d(self._odometry)
            stamp = self._odometry.header.stamp.to_sec()
            simulated = stamp < EPOCH
            track.note(stamp if simulated else stamp - self._first_stamp, self._moved,
                       self._target)
            return RobotState(
                pose=self._pose(), scan=self._scan,
                odometry=odometry, origin=track.origin, drift=track.drift, wheels=self._wheels,
                trail=track.trail.array(), history=track.history.array(), stamp=stamp,
                simulated_time=stamp if simulated else None, moved_distance=self._moved,
                true_distance=track.true_distance, speed=self._odometry.twist.twist.linear.x,
                heading=math.degrees(yaw_from_orientation(self._odometry.pose.pose.orientation)))

    def _on_odometry(self, message):
        pose = _planar_pose(message)
        if pose is None:
            return
        with self._lock:
            stamp = message.header.stamp.to_sec()
            if self._first_stamp is None:
                self._first_stamp = stamp
            self._odometry = message
            self._track.add_odometry(stamp, pose)

    def _on_ground_truth(self, message):
        pose = _planar_pose(message)
        if pose is None:
            return
        with self._lock:
            self._ground_truth = message
            self._track.add_ground_truth(message.header.stamp.to_sec(), pose)

    def _on_joints(self, message):
        with self._lock:
            self._wheels = dict(zip(message.name, message.position))

    def _on_scan(self, message):
        points = scan_points(message)
        with self._lock:
            if self._odometry is not None:
                self._scan = Scan(self._pose(), points)

    def _pose(self):
        return _pose_3d(self._ground_truth or self._odometry)

    def _on_moved(self, message):
        self._moved = message.data if math.isfinite(message.data) else None

    def _on_target(self, message):
        if math.isfinite(message.data):
            self._target = message.data


def _pose_3d(message):
    position, orientation = message.pose.pose.position, message.pose.pose.orientation
    wxyz = orientation.w, orientation.x, orientation.y, orientation.z
    length = math.hypot(*wxyz)
    return Pose3D((position.x, position.y, position.z), tuple(part / length for part in wxyz))


def _planar_pose(message):
    """Return the PlanarPose of an Odometry; None if it cannot be drawn."""
    position = message.pose.pose.position
    numbers = position.x, position.y, position.z, message.twist.twist.linear.x
    try:
        return planar_pose(message.pose.pose) if all(map(math.isfinite, numbers)) else None
    except ValueError:  # of an orientation
        return None
