"""The demo's command line."""

import argparse
import math

# Nothing of ROS: ./ws demo --help prints these options before anything is installed.
from odometry_common.kobuki import MAX_LINEAR_SPEED

PAGE_PORT = 8080
VIEW_TOLERANCE = 0.05  # degrees, half of what the demo asks for
MIN_SPEED = 0.001  # m/s; a slower robot takes half an hour
MIN_FACTOR = 0.001  # what the simulator accepts
# The tutorial of an option, and its default.
DEFAULTS = {'distance': ('move', 2.0), 'speed': ('move', 0.1), 'target': ('rotate', 90.0)}


def parse(arguments):
    """Return the options; print help or an error and exit if there is nothing to run."""
    parser = make_parser()
    options = parser.parse_args(arguments)
    for name, (tutorial, default) in DEFAULTS.items():
        if getattr(options, name) is None:
            setattr(options, name, default)
        elif options.tutorial != tutorial:
            parser.error(f'argument --{name}: is for ./ws demo {tutorial}')
    return options


def make_parser():
    """Return the parser of the command line."""
    parser = argparse.ArgumentParser(
        prog='./ws demo', description='Run a tutorial with a simulated TurtleBot 2 and show how '
        'it goes. A recording and a picture of the run are left in the folder runs.')
    parser.add_argument('tutorial', nargs='?', choices=['move', 'rotate'], default='move',
                        help='drive two metres, or turn to a heading (default: %(default)s)')
    parser.add_argument('--distance', type=_number(0.01, 1000), metavar='M',
                        help=f'move: where to stop (m; default: {DEFAULTS["distance"][1]})')
    parser.add_argument('--speed', metavar='M/S',
                        type=_number(-MAX_LINEAR_SPEED, MAX_LINEAR_SPEED, MIN_SPEED),
                        help='move: how fast (m/s; negative drives backwards; '
                             f'default: {DEFAULTS["speed"][1]})')
    parser.add_argument('--target', type=_number(-1e6, 1e6), metavar='DEGREES',
                        help=f'rotate: heading to turn to (default: {DEFAULTS["target"][1]})')
    parser.add_argument('--real-time-factor', type=_factor, default=1.0, metavar='N',
                        help='simulated seconds per second; 0: as fast as possible; other than 1, '
                             'in lockstep (default: %(default)s)')
    parser.add_argument('--gui', action='store_true', help="open PyBullet's window")
    parser.add_argument('--view', action='store_true',
                        help=f'show the robot in a browser, at http://localhost:{PAGE_PORT} or the '
                             'next free port; on a terminal the page stays after the run, until '
                             'Ctrl-C')
    return parser


def nodes_that_end(options):
    """Return the names of the nodes that end once they have done their task."""
    # Beside a page the tutorial's node does: otherwise its zero commands would fight the pad's.
    return ['test_movement', 'rotate_robot'] if options.view else []


def launch_arguments(options, page_port=None):
    """Return the launch file and a dictionary of its arguments for these options."""
    arguments = {'gui': _flag(options.gui), 'view': _flag(options.view),
                 'real_time_factor': options.real_time_factor, 'paused': 'true',
                 # At each pace but real time the robot waits for its controller.
                 'lockstep': _flag(options.real_time_factor != 1)}
    if page_port:
        arguments['view_port'] = page_port
    if options.tutorial == 'move':
        arguments.update(distance=options.distance, speed=options.speed,
                         exit_when_done=_flag(options.view))
        return 'move_two_meters.launch', arguments
    arguments.update(target=options.target, tolerance=VIEW_TOLERANCE if options.view else 0.0)
    return 'rotate.launch', arguments


def _flag(value):
    return str(value).lower()


def _number(lowest, highest, smallest=0.0):
    """Return a type for argparse: numbers in a range, whose size is at least `smallest`."""
    def parse_number(text):
        try:
            value = float(text)
        except ValueError:
            value = math.nan
        if not lowest <= value <= highest:
            raise argparse.ArgumentTypeError(
                f'{text!r} is not a number from {lowest:g} to {highest:g}')
        if abs(value) < smallest:
            raise argparse.ArgumentTypeError(f'{text!r} is smaller than {smallest:g}')
        return value
    return parse_number


def _factor(text):
    return _number(0, 100)(text) and _number(0, 100, MIN_FACTOR)(text)
