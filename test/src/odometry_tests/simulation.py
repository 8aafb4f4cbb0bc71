"""The simulated robots without ROS, with a record of what they did."""

from typing import NamedTuple

from sim_turtlebot.physics.world import World
from sim_turtlebot.robot.odometry import true_motion
from sim_turtlebot.settings import read_settings
from sim_turtlebot.simulation import Simulation as SteppedRobots


class Record(NamedTuple):
    """What the first robot did during a run; lists of sim_turtlebot.robot.odometry.Motion."""

    ground_truth: list  # after each step of time
    odometry: list  # of each odometry message


def settings_of(**parameters):
    return read_settings(parameters)


class Simulation(SteppedRobots):
    """A simulation for tests: commands last for ever, and each step is recorded."""

    def __init__(self, *starts, **parameters):
        """Put robots down at their starts, or one at zero; parameters as the node's."""
        def build_world(step_rate, usual_starts, *rest):
            return World(step_rate, starts or usual_starts, *rest)

        super().__init__(settings_of(**{'cmd_vel_timeout': 0.0, **parameters}), build_world)
        self.robot = self.robots[0]

    def run(self, duration):
        record = Record([], [])
        end = self.timeline.steps + round(duration * self.timeline.step_rate)
        while self.timeline.steps < end:
            before, rested = self.timeline.steps, self.everything_rests
            if self.advance(end if rested else before + 1):
                record.odometry.append(self.robot.odometry)
            motion = self.robot.ground_truth if rested else true_motion(self.robot.body)
            record.ground_truth.extend([motion] * (self.timeline.steps - before))
        return record

    def drive(self, linear, angular, duration):
        self.robot.command(linear, angular)
        return self.run(duration)
