"""The sweep's command line."""

import argparse

import yaml

from odometry_tools.runs.tutorials import TUTORIALS
from odometry_tools.sweep.campaign import SEEDS, Campaign, absolute_worlds, read_campaign
from odometry_tools.sweep.subjects import ROBOT, Launched, Tutorial


def parse(arguments):
    """Return the options and their Campaign; exit if they contradict each other."""
    parser = make_parser()
    options = parser.parse_args(arguments)
    if options.jobs is not None:
        SEEDS._replace(name='--jobs').check(options.jobs)
    if options.junit and not options.campaign:
        parser.error('argument --junit: only with the limits of a --campaign')
    if not (options.campaign or options.replay):
        if not 1 <= len(options.what) <= 2:
            parser.error(f'choose a tutorial, {" or ".join(TUTORIALS)}, '
                         'or a package and its launch file')
        is_launch_file = len(options.what) == 2
        if is_launch_file != (options.until is not None):
            parser.error('argument --until: a launch file needs it, a tutorial has none')
        if len(values := dict(options.set)) < len(options.set):
            parser.error('argument --set: a parameter is set twice')
        subject = (Launched(options.what, options.until) if is_launch_file
                   else Tutorial(*options.what))
        values = {name: _as_typed(*both) if is_launch_file and name not in ROBOT else both[0]
                  for name, both in values.items()}
        options.campaign = Campaign(subject,
                                    SEEDS.default if options.seeds is None else options.seeds,
                                    absolute_worlds(values), {})
    elif options.what or options.set or (options.seeds, options.until) != (None, None):
        parser.error('the file of --campaign or --replay sets tutorial, --seeds, --set and --until')
    elif options.campaign:
        options.campaign = read_campaign(options.campaign)
    return options


def make_parser():
    """Return the parser of the command line."""
    parser = argparse.ArgumentParser(
        prog='./ws sweep', allow_abbrev=False,
        description='Run a tutorial, or a launch file, many times, over a grid of parameter '
        'values and seeds. It uses all processors, prints statistics, and saves the metrics '
        'of each run in the folder runs.')
    source, machine = (parser.add_mutually_exclusive_group() for _ in range(2))
    parser.add_argument('what', nargs='*', metavar='move|rotate|PACKAGE FILE',
                        help='drive two metres; turn to a heading; or a launch file of yours')
    parser.add_argument('--until', type=float, metavar='S',
                        help='how long a run of a launch file takes (simulated s)')
    parser.add_argument('--seeds', type=int, metavar='N',
                        help='runs of each combination, each with its own seed (default: 1)')
    parser.add_argument('--set', type=_values, action='append', default=[],
                        metavar='NAME=VALUE[,VALUE...]',
                        help='values of a parameter of the nodes; each combination is run')
    source.add_argument('--campaign', metavar='FILE',
                        help='a YAML file with tutorial, seeds, set and limits, instead of these')
    parser.add_argument('--junit', metavar='FILE', help='write a case for each limit, for CI')
    machine.add_argument('--jobs', type=int, metavar='N',
                         help='processes (default: 1 per processor, '
                              '2 per processor with a launch file)')
    machine.add_argument('--cluster', metavar='tcp://HOST:PORT',
                         help='run on a Dask cluster')
    source.add_argument('--replay', nargs=2, metavar=('DIR', 'RUN'),
                         help='repeat a run of a sweep with the nodes in lockstep, '
                              'record it, and compare')
    return parser


def _as_typed(values, texts):
    """Return the texts in place of values, for roslaunch, which makes its own of off or 1.10."""
    return [text if isinstance(text, str) else value for value, text in zip(values, texts)]


def _values(text):
    """Return a name, and its values as YAML reads them and as they were typed."""
    name, separator, values = text.partition('=')
    if not (separator and values.strip()):
        raise argparse.ArgumentTypeError(f'{text!r} is not NAME=VALUE,VALUE,...')
    try:
        return name, (yaml.safe_load(f'[{values}]'), yaml.load(f'[{values}]', yaml.BaseLoader))
    except (yaml.YAMLError, RecursionError):
        raise argparse.ArgumentTypeError(f'{text!r} contains a value that is not YAML') from None
