"""The demo's command line."""

import argparse

from heading_control import turn
from odometry_common.parameters import ParameterError
from sim_turtlebot.settings import PARAMETERS as ROBOT
from straight_drive import drive

PAGE_PORT = 8080
VIEW_TOLERANCE = 0.05  # degrees, half of what the demo allows
PARAMETERS = {row.name[1:]: row for table in (ROBOT, drive.PARAMETERS, turn.PARAMETERS)
              for row in table.rows}
MODES = 'move', 'rotate'
TUTORIALS = {'distance': 'move', 'speed': 'move', 'target': 'rotate'}  # of an option


def parse(arguments):
    """Return the options; print help or an error and exit if there is nothing to run."""
    parser = make_parser()
    options = parser.parse_args(arguments)
    if options.tutorial not in MODES:  # as choices, it would hide an unknown option before it
        parser.error(f'argument tutorial: there is no {options.tutorial}, '
                     f'only {" and ".join(MODES)}')
    for name, tutorial in TUTORIALS.items():
        if getattr(options, name) is None:
            setattr(options, name, PARAMETERS[name].default)
        elif options.tutorial != tutorial:
            parser.error(f'argument --{name}: only for ./ws demo {tutorial}')
    return options


def make_parser():
    """Return the parser of the command line."""
    parser = argparse.ArgumentParser(
        prog='./ws demo', allow_abbrev=False,
        description='Run a tutorial with a simulated TurtleBot 2 and show its progress. '
        'A recording and a picture of the run are saved in the folder runs.')
    parser.add_argument('tutorial', nargs='?', metavar='|'.join(MODES), default=MODES[0],
                        help='drive two metres, or turn to a heading (default: %(default)s)')
    for name, metavar, meaning in (
            ('distance', 'M', 'move: where to stop (m'),
            ('speed', 'M/S', 'move: how fast (m/s; negative drives backwards'),
            ('target', 'DEGREES', 'rotate: heading to turn to (degrees')):
        parser.add_argument(f'--{name}', type=_value_of(name), metavar=metavar,
                            help=f'{meaning}; default: {PARAMETERS[name].default})')
    parser.add_argument('--real-time-factor', type=_value_of('real_time_factor'), default=1.0,
                        metavar='N',
                        help='simulated seconds per second; 0: as fast as possible; other than 1, '
                             'in lockstep (default: %(default)s)')
    parser.add_argument('--gui', action='store_true', help="open PyBullet's window")
    parser.add_argument('--view', action='store_true',
                        help=f'show the robot in a browser, at http://localhost:{PAGE_PORT} or the '
                             'next free port; on a terminal the page stays until Ctrl-C')
    return parser


def nodes_that_end(options):
    """Return the names of the nodes that exit once they have finished."""
    # With a page, so that the zero commands of the tutorial's node do not fight the pad.
    return ['test_movement', 'rotate_robot'] if options.view else []


def launch_arguments(options, page_port=None):
    """Return the launch file and a dictionary of its arguments for these options."""
    arguments = {'gui': options.gui, 'view': options.view,
                 'real_time_factor': options.real_time_factor, 'paused': True,
                 # At any pace but real time the robot waits for its controller.
                 'lockstep': options.real_time_factor != 1}
    if page_port:
        arguments['view_port'] = page_port
    if options.tutorial == 'move':
        arguments.update(distance=options.distance, speed=options.speed,
                         exit_when_done=options.view)
        return 'move_two_meters.launch', arguments
    arguments.update(target=options.target, tolerance=VIEW_TOLERANCE if options.view else 0.0)
    return 'rotate.launch', arguments


def _value_of(parameter):
    """Return a type for argparse: the numbers that a node's parameter accepts."""
    def number(text):
        try:
            return PARAMETERS[parameter].check(float(text))
        except ParameterError as error:
            raise argparse.ArgumentTypeError(error) from None
    return number
