"""A Kobuki's firmware: speed limits, watchdog, odometry."""

import math
import random

from odometry_common.rest import is_slow

from sim_turtlebot import kobuki
from sim_turtlebot.geometry import height_of_z
from sim_turtlebot.robot.drive_geometry import DriveGeometry
from sim_turtlebot.robot.multiplexer import VelocityMux
from sim_turtlebot.robot.odometry import STILL, EncoderOdometry, WorldOdometry, true_motion
from sim_turtlebot.robot.scanner import Scanner
from sim_turtlebot.robot.sensors import Encoders, Gyro

REST_TIME = 0.25  # s, until a slow robot is at rest
HOLD_SPEED = 1e-3  # m/s; a robot at rest that moves faster was pushed
# A robot that is placed this close to the floor (m), and this upright (0.08 degrees), is at rest.
STANDING_HEIGHT, STANDING_HEIGHT_OF_Z = 1e-4, 1 - 1e-6


class Robot:
    """One TurtleBot: commands in, motion, sensors and odometry out.

    Times are counted in physics steps. update() is called once per odometry period.
    """

    def __init__(self, body, timeline, settings, index=0):
        """Start at rest.

        :param body: sim_turtlebot.physics.turtlebot.TurtleBot, at rest on the floor
        :param timeline: sim_turtlebot.timeline.Timeline
        :param settings: of sim_turtlebot.settings.read_settings()
        :param index: of the robot; each has its own random numbers
        """
        self.body, self.index, self._timeline = body, index, timeline
        self.namespace = f'robot_{index + 1}/' if settings.robots > 1 else ''  # of topics, frames
        step_rate = timeline.step_rate
        self._speed_step = kobuki.MAX_WHEEL_ACCELERATION / step_rate
        timeout = settings.cmd_vel_timeout
        self._timeout = _whole_steps(timeout, step_rate) if timeout else math.inf
        self._rest_time = _whole_steps(REST_TIME, step_rate)
        self._rng = random.Random()
        self._geometry = geometry = DriveGeometry(settings)
        self.gyro = Gyro(settings, self._rng)
        if settings.odometry_source == 'world':
            self._encoders, self.estimator = None, WorldOdometry()
        else:
            self._encoders = Encoders(settings, self._rng)
            self.estimator = EncoderOdometry(self._encoders, self.gyro, geometry, settings.gyro)
        self.scanner = Scanner(body, settings, index) if settings.scan else None
        self.begin(settings.seed)

    @property
    def resting(self):
        """Whether the robot is at rest, without a command to move."""
        return self._anchor is not None

    @property
    def wheels(self):
        """Angles (rad), velocities (rad/s) and torques (N m) of the left and right wheel."""
        return self._anchor[1] if self._anchor else self.body.wheels()

    def command(self, linear, angular, topic=None):
        """Move from now on at `linear` m/s and `angular` rad/s, within the limits of the base.

        :param topic: on which the command has come; the multiplexer may block it
        :raises ValueError: if one of them is not finite; the robot then stops
        """
        now = self._timeline.steps
        if not self._mux.passes(topic, now):
            return
        if not (math.isfinite(linear) and math.isfinite(angular)):
            self.stop()
            raise ValueError(f'the velocity ({linear} m/s, {angular} rad/s) is not finite')
        self._watchdog_expires = now + self._timeout
        self._obey(_clamp(linear, kobuki.MAX_LINEAR_SPEED),
                   _clamp(angular, kobuki.MAX_ANGULAR_SPEED))

    def stop(self):
        """Command zero."""
        self._watchdog_expires = math.inf
        self._obey(0.0, 0.0)

    def is_steady_until(self, end):
        """Return whether before_step() does nothing until step `end`."""
        return self._driven == self._commanded and end <= self._watchdog_expires + 1

    def before_step(self, now):
        """Check the watchdog, and accelerate or brake; call this before each physics step."""
        if now > self._watchdog_expires:
            self.timed_out = self._commanded != (0.0, 0.0)
            self.stop()
        if self._driven != self._commanded:
            self._accelerate()

    def update(self):
        """Update ground truth, then sensors, then odometry."""
        duration = 1.0 / self._timeline.odom_rate
        self.ground_truth = true_motion(self.body)
        if self._anchor is not None:
            self._hold(duration)
        elif self._commanded == self._driven == (0.0, 0.0):
            self._detect_rest(self._timeline.steps)
        if self._encoders:  # reading the wheels takes as long as a physics step
            self._encoders.update(self.wheels[0])
        self.gyro.update(self.ground_truth.orientation, duration)
        self.odometry = self.estimator.update(self.ground_truth, duration)

    def set_pose(self, position, orientation):
        """Place the robot at rest, without turning its wheels.

        :param position: x, y, z (m) in the world; z is 0 on the floor
        :param orientation: quaternion x, y, z, w of length 1
        :raises ValueError: if something is in the way; the robot stops where it is
        """
        wheel_angles = self.wheels[0]
        self._forget_commands()
        self.body.put(position, orientation, wheel_angles)
        self.ground_truth = true_motion(self.body)
        stands = (abs(position[2]) <= STANDING_HEIGHT
                  and height_of_z(orientation) >= STANDING_HEIGHT_OF_Z)
        self._anchor = self._standing() if stands else None
        self.gyro.teleport(self.ground_truth.orientation)
        self.odometry = self.estimator.teleport(self.ground_truth)

    def reset_odometry(self):
        """Reset odometry and gyro to zero at the current pose."""
        self.gyro.reset(self.ground_truth.orientation)
        self.odometry = self.estimator.reset(self.ground_truth)

    def begin(self, seed):
        """Start at rest where the body is, and seed the random numbers."""
        # A string, since seed + index is robot 1's with the next seed, and Python seeds -5 like 5.
        self._rng.seed(seed if seed >= 0 and self.index == 0 else f'{seed} {self.index}')
        if self.scanner:
            self.scanner.seed = seed
        self._mux = VelocityMux(self._timeline.step_rate)
        self._forget_commands()
        self.ground_truth = true_motion(self.body)
        self._anchor = self._standing()
        if self._encoders:
            self._encoders.reset(self.wheels[0])
        self.reset_odometry()

    def _forget_commands(self):
        """Reset command, speed and watchdog."""
        self._commanded = self._driven = (0.0, 0.0)
        self._watchdog_expires = math.inf
        self.timed_out = False  # whether the watchdog has stopped a moving robot
        self._slow_since = None

    def _obey(self, linear, angular):
        if (linear, angular) != self._commanded:
            self._commanded = (linear, angular)
            self._anchor = self._slow_since = None

    def _accelerate(self):
        """Move both wheel speeds towards the command, in proportion."""
        linear, angular = (wanted - now for wanted, now in zip(self._commanded, self._driven))
        change = abs(linear) + abs(angular) * kobuki.WHEEL_SEPARATION / 2  # of the faster wheel
        if change <= self._speed_step:
            self._driven = self._commanded
        else:
            share = self._speed_step / change
            self._driven = (self._driven[0] + share * linear, self._driven[1] + share * angular)
        self.body.drive(*self._geometry.wheel_speeds(*self._driven))

    def _detect_rest(self, now):
        """Hold the robot once it has been slow for REST_TIME."""
        truth = self.ground_truth
        if not is_slow(math.hypot(*truth.linear), math.hypot(*truth.angular)):
            self._slow_since = None
        elif self._slow_since is None:
            self._slow_since = now
        elif now - self._slow_since >= self._rest_time:
            self._anchor = self._standing()

    def _standing(self):
        angles, _, torques = self.body.wheels()
        self.ground_truth = self.ground_truth._replace(linear=STILL, angular=STILL)
        return self.ground_truth, (angles, (0.0, 0.0), torques)

    def _hold(self, duration):
        """Undo creep, as static friction would; release the robot if it was pushed."""
        ground_truth, wheels = self._anchor
        if math.dist(self.ground_truth.position, ground_truth.position) > HOLD_SPEED * duration:
            self._anchor = self._slow_since = None
            return
        self.body.place(ground_truth.position, ground_truth.orientation, wheels[0])
        self.ground_truth = ground_truth


def _whole_steps(duration, step_rate):
    """Return how many whole steps fit into a duration (s)."""
    return int(duration * step_rate + 1e-6)  # rounding must not take away a step


def _clamp(value, limit):
    return max(-limit, min(limit, value))
