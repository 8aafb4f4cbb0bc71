"""Measure speed, delay, memory and start, each beside the limit of this machine.

A figure's limit is measured in turns with the figure itself; their ratio is what tells, since
absolute values belong to the machine. The exit status is 1 if a target was missed.
"""

import argparse
import math
import sys
from pathlib import Path

import rospy
from control import control_in_lockstep, control_unpaced
from demos import demo
from latency import detector_latency
from lockstep import graph_in_lockstep
from measuring import Options
from memory import memory
from odometry_launch.folders import RUNS, new_folder
from odometry_tests.processes import Master
from report import machine, print_figure, print_heading, write_chart, write_csv
from robots import many_robots
from speed import clock_ticks, graph_unpaced, graph_with_scan, robot_without_ros
from start import end, start
from sweeps import sweep
from viewing import viewing

MEASUREMENTS = {
    'robot': robot_without_ros, 'unpaced': graph_unpaced, 'lockstep': graph_in_lockstep,
    'scan': graph_with_scan, 'clock': clock_ticks, 'sweep': sweep,
    'control': control_unpaced, 'control-lockstep': control_in_lockstep,
    'latency': detector_latency, 'memory': memory, 'start': start, 'end': end, 'demo': demo,
    'robots': many_robots, 'view': viewing}


def main():
    """Measure, report, and exit 0 if all targets are met."""
    options = parse(sys.argv[1:])
    print(f'on {machine()}; medians of {options.runs} runs')
    with Master(use_sim_time=True):
        # The clock of the simulators must not become the clock of what measures them.
        rospy.init_node('bench', disable_signals=True, disable_rostime=True)
        print_heading()
        figures = list(_measure(options))
    folder = new_folder(RUNS, 'bench-')
    write_csv(figures, options.csv or folder / 'figures.csv')
    print(f'figures  {options.csv or folder / "figures.csv"}')
    if 'robots' in options.only:
        write_chart(figures, folder / 'robots.png')
        print(f'chart    {folder / "robots.png"}')
    missed = [figure.name for figure in figures if figure.misses]
    print(f'targets missed: {", ".join(missed) or "none"}')
    sys.exit(1 if missed else 0)


def _measure(options):
    effort = Options(options.runs, options.window, messages=1000, longest=3, minutes=10)
    for name in options.only:
        for figure in MEASUREMENTS[name](effort):
            print_figure(figure)
            yield figure


def parse(arguments):
    """Return the options; without the name of a part all parts are measured."""
    parser = argparse.ArgumentParser(prog='./ws bench', description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('only', nargs='*', metavar='PART', default=list(MEASUREMENTS),
                        type=_part,
                        help=f'measure only these: {", ".join(MEASUREMENTS)}')
    parser.add_argument('--runs', type=_positive(int), default=3, metavar='N',
                        help='of which the median is shown (default: %(default)s)')
    parser.add_argument('--window', type=_positive(float), default=1.0, metavar='S',
                        help='wall time of one look at a speed (default: %(default)s)')
    parser.add_argument('--csv', type=Path, metavar='FILE',
                        help='write the figures there instead of into the folder runs')
    return parser.parse_args(arguments)


def _part(name):
    if name not in MEASUREMENTS:
        raise argparse.ArgumentTypeError(
            f'{name!r} is not one of {", ".join(MEASUREMENTS)}')
    return name


def _positive(kind):
    def parse_number(text):
        try:
            value = kind(text)
        except ValueError:
            value = 0
        if not 0 < value < math.inf:
            raise argparse.ArgumentTypeError(f'{text!r} is not a positive number')
        return value
    return parse_number


if __name__ == '__main__':
    main()
