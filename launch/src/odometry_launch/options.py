"""The demo's command line."""

import argparse
import math

from odometry_launch.page import URL

MAX_SPEED = 0.7  # m/s, TurtleBot 2
VIEW_TOLERANCE = 0.05  # degrees, half of what the demo asks for
MIN_SPEED = 0.001  # m/s; slower than this no reader would wait


def parse(arguments):
    """Return the options; print help or a complaint and exit if there is nothing to run."""
    parser = argparse.ArgumentParser(
        prog='./ws demo', description='Run a tutorial with a simulated TurtleBot 2 and show how '
        'it goes. A recording and a picture of the run are left in the folder runs.')
    parser.add_argument('tutorial', nargs='?', choices=['move', 'rotate'], default='move',
                        help='drive two metres, or turn to a heading (default: %(default)s)')
    parser.add_argument('--distance', type=_number(0.01, 1000), default=2.0, metavar='M',
                        help='move: where to stop (m; default: %(default)s)')
    parser.add_argument('--speed', type=_speed, default=0.1, metavar='M/S',
                        help='move: how fast (m/s; negative drives backwards; '
                             'default: %(default)s)')
    parser.add_argument('--target', type=_number(-1e6, 1e6), default=90.0, metavar='DEGREES',
                        help='rotate: heading to turn to (default: %(default)s)')
    parser.add_argument('--real-time-factor', type=_number(0, 100), default=1.0, metavar='N',
                        help='simulated seconds per second; 0: as fast as possible. At '
                             'each but 1 the robot waits for its controller, so that it goes '
                             'equally far (default: %(default)s)')
    parser.add_argument('--gui', action='store_true', help="open PyBullet's window")
    parser.add_argument('--view', action='store_true',
                        help=f'show the robot in a browser, at {URL}; on a terminal the page '
                             'stays after the run, and its pad drives the robot, until Ctrl-C')
    return parser.parse_args(arguments)


def in_lockstep(options):
    """Return whether the robot waits for its controller: what is not shown in real time does."""
    return options.real_time_factor != 1


def launch_arguments(options):
    """Return the launch file and its arguments for these options."""
    arguments = {'gui': _flag(options.gui), 'view': _flag(options.view),
                 'real_time_factor': options.real_time_factor,
                 'lockstep': _flag(in_lockstep(options))}
    # Beside a page the tutorial's node ends once it has arrived, or it would go on to command
    # zero, against the page's pad.
    if options.tutorial == 'move':
        arguments.update(distance=options.distance, speed=options.speed,
                         exit_when_done=_flag(options.view))
        return 'move_two_meters.launch', arguments
    arguments.update(target=options.target, tolerance=VIEW_TOLERANCE if options.view else 0.0)
    return 'rotate.launch', arguments


def _flag(value):
    return str(value).lower()


def _number(lowest, highest):
    def parse_number(text):
        try:
            value = float(text)
        except ValueError:
            value = math.nan
        if not lowest <= value <= highest:
            raise argparse.ArgumentTypeError(
                f'{text!r} is not a number from {lowest:g} to {highest:g}')
        return value
    return parse_number


def _speed(text):
    value = _number(-MAX_SPEED, MAX_SPEED)(text)
    if abs(value) < MIN_SPEED:
        raise argparse.ArgumentTypeError(f'{text!r} is slower than {MIN_SPEED:g} m/s')
    return value
