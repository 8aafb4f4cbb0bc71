"""The detector's parameters."""

from odometry_common.parameters import Parameter, Parameters, at_least

PARAMETERS = Parameters(
    Parameter('~min_step', 0.0, 'm', at_least(0),
              'count the displacement from the last counted position only once it reaches this'),
    Parameter('~max_speed', 5.0, 'm/s', at_least(0),
              'warn once of a faster step, a jump of the odometry, and do not count it; 0 counts '
              'every step'))
