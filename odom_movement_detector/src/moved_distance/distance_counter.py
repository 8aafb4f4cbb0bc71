"""How far a robot has moved, added up from where its odometry has it."""

import math

from moved_distance.steps import Steps

SMALLEST_DISTANCE = 1e-6  # m; a smaller total is given as zero, as in the tutorial


class DistanceCounter:
    """The sum of the steps between consecutive positions in the plane."""

    def __init__(self, min_step=0.0, max_speed=5.0):
        """Take the smallest step counted (m) and the speed (m/s, 0: any) of a jump."""
        self._steps = Steps(min_step, max_speed)
        self._total = 0.0

    @property
    def distance(self):
        """Metres counted so far; exactly 0.0 while under a micrometre."""
        return self._total if self._total >= SMALLEST_DISTANCE else 0.0

    def reset(self):
        """Start from zero at the last position."""
        self._total = 0.0
        self._steps.restart()

    def add(self, x, y, stamp, arrival):
        """Take the robot's next position; parameters and errors are those of Steps.to().

        :return: None, or why this step was not counted
        """
        dx, dy, jump = self._steps.to(x, y, stamp, arrival)
        self._total += math.hypot(dx, dy)
        return jump
