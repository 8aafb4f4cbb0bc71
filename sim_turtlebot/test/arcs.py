"""Motions that are made up, for an odometry to see."""

import math

from odometry_tests.simulation import settings_of
from sim_turtlebot.geometry import about_z, rotate
from sim_turtlebot.kobuki import TICKS_PER_TURN, WHEEL_RADIUS, WHEEL_SEPARATION
from sim_turtlebot.robot.odometry import STILL, Motion
from sim_turtlebot.robot.robot import Robot as SimulatedRobot
from sim_turtlebot.timeline import Timeline

SPEED = 0.1  # m/s
PERIOD = 0.05  # s between two odometries at 20 Hz
TICK = math.tau * WHEEL_RADIUS / TICKS_PER_TURN  # m


def motion(x=0.0, y=0.0, yaw=0.0, linear=STILL, angular=STILL):
    """Return a Motion on the floor at x, y (m), yaw (rad)."""
    return Motion((x, y, 0.0), about_z(yaw), linear, angular)


def wheel_angles(travel, turn):
    """Return the angles (rad) to which wheels that roll true have turned."""
    difference = turn * WHEEL_SEPARATION / 2
    return (travel - difference) / WHEEL_RADIUS, (travel + difference) / WHEEL_RADIUS


def on_arc(speed, turn_speed, time):
    """Return the true x, y (m), yaw (rad) at a time (s) after a start at zero."""
    yaw = turn_speed * time
    if abs(turn_speed) < 1e-9:
        return speed * time, 0.0, yaw
    radius = speed / turn_speed
    return radius * math.sin(yaw), radius * (1 - math.cos(yaw)), yaw


class Body:
    """A body without physics: it is where the test puts it."""

    def __init__(self):
        self.motion, self.angles = motion(), (0.0, 0.0)

    def pose(self):
        return self.motion[:2]

    def velocity(self):
        return [rotate(self.motion.orientation, vector) for vector in self.motion[2:]]

    def wheels(self):
        return self.angles, (0.0, 0.0), (0.0, 0.0)

    def drive(self, _left, _right):
        """Turn no wheel."""

    def place(self, position, orientation, _wheel_angles):
        self.motion = Motion(position, orientation, STILL, STILL)

    put = place


class Robot(SimulatedRobot):
    """A robot on a Body, for its sensors and its odometry; parameters as the node's."""

    def __init__(self, **parameters):
        settings = settings_of(**parameters)
        self._seed = settings.seed
        super().__init__(Body(), Timeline(settings.odom_rate), settings)

    def start(self, motion, angles=(0.0, 0.0)):
        self.body.motion, self.body.angles = motion, angles
        self.begin(self._seed)
        return self.odometry

    def move(self, motion, angles=(0.0, 0.0)):
        self.body.motion, self.body.angles = motion, angles
        self.command(SPEED, 0.0)  # else it would be held
        self.update()
        return self.odometry


def drive(robot, speed, turn_speed=0.0, duration=10.0):
    """Drive an arc from a start at zero; return the odometry after each period."""
    robot.start(motion())
    times = [number * PERIOD for number in range(1, round(duration / PERIOD) + 1)]
    return [robot.move(motion(*on_arc(speed, turn_speed, time)),
                       wheel_angles(speed * time, turn_speed * time)) for time in times]
