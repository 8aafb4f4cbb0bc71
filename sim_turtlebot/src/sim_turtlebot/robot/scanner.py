"""The laser scan of a TurtleBot 2's depth camera, by ray casting; no ROS."""

import math

import numpy
from odometry_common.kobuki import DEPTH_CAMERA

# As turtlebot_description's camera in Gazebo (turtlebot_gazebo.urdf.xacro): 640 pixels wide, 10 Hz.
BEAMS = 640
RATE = 10.0  # Hz
# rad; 60.2 degrees. The camera in Gazebo has 60, the data sheet of the Asus Xtion Pro 58. The margin
# is for clients that count 30 degrees in beams to each side, and round up.
FIELD_OF_VIEW = 1.05
RANGE_MIN = 0.45  # m; turtlebot_bringup/launch/3dsensor.launch
RANGE_MAX = 10.0  # m; the default of depthimage_to_laserscan


class Scanner:
    """Measures the distance to the robot's surroundings along a horizontal fan of beams."""

    def __init__(self, body, beams=BEAMS, field_of_view=FIELD_OF_VIEW, range_min=RANGE_MIN,
                 range_max=RANGE_MAX, noise=0.0, seed=(0,)):
        """Spread the beams evenly over the field of view (rad).

        :param body: sim_turtlebot.physics.turtlebot.TurtleBot
        :param range_min, range_max: m
        :param noise: standard deviation of a range (m)
        :param seed: of the noise: whole numbers from 0 to 2**32 - 1, in a tuple
        """
        self.field_of_view = field_of_view
        self.beams = beams
        self.range_min, self.range_max = range_min, range_max
        self._cast_rays = body.cast_rays
        self._noise = noise
        self._seed = seed
        angles = numpy.linspace(-field_of_view / 2, field_of_view / 2, beams)
        directions = numpy.column_stack([numpy.cos(angles), numpy.sin(angles), numpy.zeros(beams)])
        self._starts = [DEPTH_CAMERA] * beams
        self._ends = (DEPTH_CAMERA + range_max * directions).tolist()

    def scan(self, number):
        """Return the ranges (m) from right to left, as REP-117 defines them.

        +inf: nothing up to range_max. -inf: something nearer than range_min.

        :param number: of the odometry period, from 0; it alone seeds the noise, so a repeated scan
            is the same
        """
        shares = numpy.array(self._cast_rays(self._starts, self._ends))
        ranges = self.range_max * shares
        if self._noise:
            # numpy guarantees a stable sequence for this generator only.
            rng = numpy.random.RandomState([*self._seed, number])
            ranges += rng.normal(0.0, self._noise, self.beams)
        ranges[(shares == 1.0) | (ranges > self.range_max)] = math.inf
        ranges[ranges < self.range_min] = -math.inf
        return ranges


def is_scan_due(odometry_count, scan_rate, odom_rate):
    """Return whether this odometry period is the first at or after a multiple of 1 / scan_rate.

    :param odometry_count: how many odometry periods have passed
    :param scan_rate, odom_rate: Hz; scans are taken with odometry only
    """
    before, now = (_whole_scans(count, scan_rate / odom_rate)
                   for count in (odometry_count - 1, odometry_count))
    return now > before


def _whole_scans(count, share):
    # The small term keeps a scan at its odometry despite rounding.
    return math.floor(count * share + 1e-6)
