"""Robots in a world, stepped through simulated time; the only place that steps them. No ROS."""

import math

from sim_turtlebot.physics.world import World
from sim_turtlebot.robot.robot import Robot
from sim_turtlebot.timeline import Timeline

SPACING = 1.0  # m, from one robot's start to that of the next on its left


class Simulation:
    """TurtleBots that share a world and a timeline."""

    def __init__(self, settings, build_world=World):
        """Place the robots.

        :param settings: of sim_turtlebot.settings.read_settings()
        :param build_world: function of the parameters of World, whose errors it raises
        """
        to_left = -SPACING * math.sin(settings.yaw), SPACING * math.cos(settings.yaw)
        starts = [(settings.x + index * to_left[0], settings.y + index * to_left[1], settings.yaw)
                  for index in range(settings.robots)]
        self.timeline = Timeline(settings.odom_rate, settings.clock_rate)
        self.world = build_world(self.timeline.step_rate, starts, settings.gui, settings.world)
        self.robots = [Robot(body, self.timeline, settings, index)
                       for index, body in enumerate(self.world.robots)]

    @property
    def everything_rests(self):
        """Whether nothing moves before the next command."""
        return self.world.only_robots_move and all(robot.resting for robot in self.robots)

    def advance(self, last_step=math.inf):
        """Step to the next tick of the clock, but not past `last_step`.

        The physics is skipped while everything rests: it is cheaper, and nothing can creep.

        :return: whether there is new odometry
        """
        timeline, robots, step = self.timeline, self.robots, self.world.step
        # Robots start and stop moving only at tick boundaries.
        moving = not self.everything_rests
        begin = timeline.steps
        timeline.advance(last_step)
        if all(robot.is_steady_until(timeline.steps) for robot in robots):
            if moving:
                step(timeline.steps - begin)
        else:
            for now in range(begin, timeline.steps):
                for robot in robots:
                    robot.before_step(now)
                if moving:
                    step()
        if not timeline.odometry_is_due:
            return False
        for robot in robots:
            robot.update()
        return True

    def reset(self, seed):
        """Return to the start; the same commands then give the bits of a new simulation.

        :param seed: that of the new simulation
        """
        self.timeline.restart()
        self.world.rebuild()
        for robot in self.robots:
            robot.begin(seed)
