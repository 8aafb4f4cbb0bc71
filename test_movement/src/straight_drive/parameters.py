"""The mover's parameters."""

from odometry_common.parameters import ANY, Parameter, Parameters, Range, above, between

PARAMETERS = Parameters(
    Parameter('~distance', 2.0, 'm', above(0), 'where to stop'),
    Parameter('~speed', 0.1, 'm/s', Range('other than 0', lambda value, _: value != 0),
              'how fast; negative drives backwards'),
    Parameter('~relative', False, '', ANY,
              "count from the first message, not from the detector's start: a second run moves "
              'again'),
    Parameter('~exit_when_done', False, '', ANY,
              'exit once the robot has stopped; otherwise command zero for ever'),
    Parameter('~timeout', 1.0, 's', between(0, 3600),
              'while the robot moves, stop and warn after this long without a message (ROS time, '
              'and at least 0.2 s of wall time); continue when messages return; 0 turns it off'))
