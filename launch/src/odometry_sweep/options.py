"""The sweep's command line."""

import argparse
from pathlib import Path

from odometry_sweep.campaign import Campaign, parse_values, read_campaign
from odometry_sweep.tutorials import TUTORIALS


def parse(arguments):
    """Return the options, with the campaign among them; exit if they make no sense."""
    parser = make_parser()
    options = parser.parse_args(arguments)
    if options.cluster and options.jobs:
        parser.error('argument --jobs: the workers of a --cluster are as many as they are')
    if options.replay:
        if options.tutorial or options.set or options.seeds or options.campaign:
            parser.error('argument --replay: the folder says all of tutorial, --seeds and --set')
        options.replay = Path(options.replay[0]), _number_of_run(parser, options.replay[1])
    elif options.campaign:
        if options.tutorial or options.set or options.seeds:
            parser.error('argument --campaign: the file says all of tutorial, --seeds and --set')
        options.campaign = read_campaign(options.campaign)
    elif not options.tutorial:
        parser.error('say which tutorial: move or rotate')
    else:
        values = dict(options.set)
        if len(values) < len(options.set):
            parser.error('argument --set: a parameter is set twice')
        options.campaign = Campaign(options.tutorial, options.seeds or 1, values, {})
    return options


def make_parser():
    """Return the parser of the command line."""
    parser = argparse.ArgumentParser(
        prog='./ws sweep', description='Run a tutorial many times, over a grid of parameter values '
        'and seeds, without ROS. All processors are used, what came out is printed, and the '
        'figures of each run are left in the folder runs.')
    parser.add_argument('tutorial', nargs='?', choices=TUTORIALS,
                        help='drive two metres, or turn to a heading')
    parser.add_argument('--seeds', type=_whole, metavar='N',
                        help='how many runs of each combination of values, each with another seed '
                             '(default: 1)')
    parser.add_argument('--set', type=_values, action='append', default=[],
                        metavar='NAME=VALUE[,VALUE...]',
                        help='the values of a parameter of the nodes; each combination of all is '
                             'run')
    parser.add_argument('--campaign', metavar='FILE',
                        help='a YAML file with tutorial, seeds, set and limits, instead of these')
    parser.add_argument('--jobs', type=_whole, metavar='N',
                        help='processes that run side by side, at most two for each processor and '
                             'one for each run (default: one for each processor)')
    parser.add_argument('--cluster', metavar='tcp://HOST:PORT',
                        help='have the workers of a Dask cluster do the runs, instead of the '
                             'processors of this machine')
    parser.add_argument('--replay', nargs=2, metavar=('DIR', 'RUN'),
                        help='run one of the runs in the folder of a sweep by the nodes '
                             'themselves, in lockstep and recorded, and compare to the last bit')
    return parser


def _number_of_run(parser, text):
    try:
        return _whole(text)
    except argparse.ArgumentTypeError as error:
        parser.error(f'argument --replay: {error}')


def _whole(text):
    if not text.isdecimal() or not 1 <= int(text) <= 10**6:
        raise argparse.ArgumentTypeError(f'{text!r} is not a whole number from 1 to 1000000')
    return int(text)


def _values(text):
    try:
        return parse_values(text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None
