"""Detect robots that tip over."""

from odometry_common.geometry import is_upright


class FallDetector:
    """Notices when a robot falls on its side, and when it stands upright again.

    All robots, each a sim_turtlebot.robot.robot.Robot, stand upright at first.
    """

    def __init__(self, robots):
        self._robots = {f'robot_{number}' if len(robots) > 1 else 'the robot': robot
                        for number, robot in enumerate(robots, 1)}
        self._lying = set()

    def changes(self):
        """Yield the name of each robot that has fallen since the last call, with a warning.

        For a robot that stands upright again, the warning is empty.
        """
        for name, robot in self._robots.items():
            if is_upright(robot.ground_truth.orientation) == (name in self._lying):
                self._lying ^= {name}
                # Adding zero turns -0.0 into 0.0.
                x, y = (round(metres, 2) + 0.0 for metres in robot.ground_truth.position[:2])
                yield name, (f'{name} lies on its side at x {x:g}, y {y:g}; ~reset_simulation brings it back'
                             if name in self._lying else '')
