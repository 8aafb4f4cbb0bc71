"""The detector's parameters."""

from odometry_common.parameters import Parameter, Parameters, at_least

PARAMETERS = Parameters(
    Parameter('~min_step', 0.0, 'm', at_least(0),
              'a displacement from the last counted position that is below this is not counted '
              'until it has grown'),
    Parameter('~max_speed', 5.0, 'm/s', at_least(0),
              'a faster step is a jump of the odometry and is not counted, with one warning; 0 '
              'counts every step. Each step may take the usual time between messages, however '
              'their stamps are bunched'))
