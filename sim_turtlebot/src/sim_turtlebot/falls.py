"""Robots that lie on their side."""

from odometry_common.geometry import is_upright


class Falls:
    """Notices when a robot begins to lie on its side, and when it stands again."""

    def __init__(self, robots):
        """Watch robots that stand, each a sim_turtlebot.robot.robot.Robot."""
        self._robots = {f'robot_{number}' if len(robots) > 1 else 'the robot': robot
                        for number, robot in enumerate(robots, 1)}
        self._lying = set()

    def look(self):
        """Yield the name of each robot that has fallen, or stands again, since the last look.

        With it comes a warning; an empty one for a robot that stands again.
        """
        for name, robot in self._robots.items():
            if is_upright(robot.ground_truth.orientation) == (name in self._lying):
                self._lying ^= {name}
                yield name, _warning(name, robot) if name in self._lying else ''


def _warning(name, robot):
    # Adding zero takes the sign from a zero.
    x, y = (round(metres, 2) + 0.0 for metres in robot.ground_truth.position[:2])
    return f'{name} lies on its side at x {x:g}, y {y:g}; ~reset_simulation brings it back'
