"""The simulated robots without ROS: stepped and asked as the node does it."""

from typing import NamedTuple

from sim_turtlebot.odometry import WorldOdometry, true_motion
from sim_turtlebot.physics import World
from sim_turtlebot.robot import Robot
from sim_turtlebot.timeline import Timeline

AT_ZERO = (0.0, 0.0, 0.0)


class Record(NamedTuple):
    """What the first robot did during a run; lists of sim_turtlebot.odometry.Motion."""

    truth: list  # after each step of time
    odometry: list  # of each odometry message


class Simulation:
    """Robots in one world, in simulated time, as fast as PyBullet can."""

    def __init__(self, *starts, odometry=WorldOdometry, cmd_vel_timeout=0.0, odom_rate=20.0,
                 world_file=''):
        """Put robots down.

        :param starts: x, y (m) and yaw (rad) of each robot; none: one robot at zero
        :param odometry: function that returns a robot's odometry
        :param cmd_vel_timeout: seconds, 0: never
        :param odom_rate: Hz
        :param world_file: path of a URDF or SDF file to load beside the floor
        """
        self._timeline = Timeline(odom_rate)
        self._world = World(self._timeline.step_rate, world_file=world_file)
        bodies = [self._world.add_turtlebot(*start) for start in starts or [AT_ZERO]]
        self._world.settle()
        self.robots = [Robot(body, self._timeline.step_rate, odometry(), cmd_vel_timeout)
                       for body in bodies]
        self.robot = self.robots[0]

    def command(self, linear, angular, robot=0):
        """Command a robot (an index) to move at `linear` m/s and `angular` rad/s."""
        self.robots[robot].command(linear, angular, self._timeline.steps)

    def run(self, duration):
        """Simulate so many seconds; return the Record of the first robot."""
        record = Record([], [])
        for _ in range(round(duration * self._timeline.step_rate)):
            moved = self._step()
            record.truth.append(true_motion(self.robot.body) if moved else self.robot.truth)
            if self._timeline.odometry_is_due:
                self._tick()
                record.odometry.append(self.robot.odometry)
        return record

    def drive(self, linear, angular, duration):
        """Command the first robot and run; return the Record."""
        self.command(linear, angular)
        return self.run(duration)

    def reset(self):
        """Take time and robots back to the start."""
        self._timeline.steps = 0
        for robot in self.robots:
            robot.reset()

    def _step(self):
        """Advance time, and the physics unless everything rests; tell whether it was needed."""
        for robot in self.robots:
            robot.before_step(self._timeline.steps)
        moved = not all(robot.resting for robot in self.robots)
        if moved:
            self._world.step()
        self._timeline.steps += 1
        return moved

    def _tick(self):
        for robot in self.robots:
            robot.tick(self._timeline.steps, 1 / self._timeline.odom_rate)
