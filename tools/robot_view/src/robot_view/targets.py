"""The targets of the tutorials' nodes."""

import math

import rospy
from odometry_common.parameters import as_number
from sim_turtlebot.geometry import PlanarPose

MOVER, ROTATOR = 'test_movement', 'rotate_robot'
DISTANCE, SPEED = 2.0, 0.1  # m, m/s; the mover's defaults


class Targets:
    """The targets of one robot's mover and rotator, while they run; each None if unknown."""

    def __init__(self, namespace):
        self.heading = None  # degrees
        self.distance = None  # moved distance at which the mover stops (m)
        self.goal = None  # where that is: a PlanarPose in the odometry's frame
        self._namespace = namespace
        self._running = set()  # which of the two nodes run
        self._sign = 1.0  # of the mover's speed
        self._is_relative = False  # whether the mover counts from its start
        self._rest = None  # pose and moved distance when the robot was last at rest

    def find(self, nodes):
        """Read the targets of the nodes that have started.

        :param nodes: the names of all that run
        :raises rosgraph.MasterException, OSError: if the master does not answer
        """
        running = {node for node in (MOVER, ROTATOR)
                   if rospy.resolve_name(self._namespace + node) in nodes}
        started = running - self._running
        if ROTATOR not in running:
            self.heading = None
        if ROTATOR in started:
            self.heading = self._read(ROTATOR, 'target', None)
        if MOVER in started:
            self.distance = self._read(MOVER, 'distance', DISTANCE)
            self._sign = math.copysign(1.0, self._read(MOVER, 'speed', SPEED))
            self._is_relative = bool(rospy.get_param(self._name(MOVER, 'relative'), False))
            self.goal = None
        self._running = running

    def aim(self, pose, moved, speed):
        """Find the goal once, ahead of a robot.

        :param pose: PlanarPose of the robot
        :param moved: how far it has moved (m)
        :param speed: of the robot (m/s)

        A mover that counts from its start begins where the robot was last at rest.
        """
        if speed == 0:
            self._rest = pose, moved
        if self.goal is not None or MOVER not in self._running or moved is None:
            return
        if self._is_relative:
            pose, moved = self._rest or (None, None)
            if moved is None:
                return
            self.distance += moved
        self.goal = pose.then(PlanarPose(self._sign * (self.distance - moved), 0.0, 0.0))

    def _read(self, node, name, default):
        value = as_number(rospy.get_param(self._name(node, name), default))
        return default if value is None else value

    def _name(self, node, name):
        return f'{self._namespace}{node}/{name}'
