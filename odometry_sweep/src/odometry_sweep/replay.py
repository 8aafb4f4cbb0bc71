"""Repeat one run of a sweep with the nodes in lockstep, record it, and compare the metrics."""

import csv
import itertools
import tempfile
from pathlib import Path

import yaml
from odometry_common.parameters import StartError
from odometry_launch.folders import use_writable_logs
from odometry_launch.output import DemoError
from odometry_launch.recording import leave_picture
from odometry_launch.stepping import record

from odometry_sweep.campaign import read_campaign
from odometry_sweep.closed_loop import follow, run_parameters
from odometry_sweep.launched import is_robots
from odometry_sweep.recorded import read
from odometry_sweep.results import CAMPAIGN_FILE, FILE, METRICS, read_rows


def replay(folder, number):
    """Replay the run with a number (a string) in the folder of a sweep.

    :raises DemoError: if the result differs, or there is none
    :raises StartError: if there is no such run
    """
    campaign, parameters, row = _find(Path(folder), number)
    use_writable_logs()
    targets = {}
    if campaign.launched:
        metrics, bag = campaign.launched.record(parameters)
    else:
        bag = _record(campaign.tutorial, parameters, float(row['time']))
        metrics = metrics_of(bag, campaign.tutorial, parameters)
        targets = run_parameters(campaign.tutorial, parameters)[0].targets
    print(f'{"":16}{"sweep":24}nodes in lockstep')
    for name in (names := [*METRICS[campaign.tutorial], 'ended']):
        print(f'{name:16}{row[name]:24}{metrics[name]}')
    leave_picture(bag, **targets)
    different = [name for name in names if row[name] != str(metrics[name])]
    if different:
        raise DemoError(f'not the same: {", ".join(different)}')
    print('the same, to the last bit', flush=True)


def _find(folder, number):
    """Return the Campaign and the parameters of a run, and its row of strings."""
    campaign = read_campaign(folder / CAMPAIGN_FILE)
    campaign.check()
    try:
        row = {row['run']: row for row in read_rows(folder)}[number]
        parameters = next(itertools.islice(campaign.runs(), int(number) - 1, None))
        float(row['time'])
        return campaign, parameters, row
    except (OSError, KeyError, TypeError, ValueError, StopIteration, csv.Error):
        raise StartError(f'{folder / FILE} has no run {number}, or only a part of it') from None


def _record(tutorial, parameters, end):
    """Run the nodes until a simulated time (s), and record them; return the path of the bag."""
    _, settings = run_parameters(tutorial, parameters)
    robot = {name: value for name, value in parameters.items() if is_robots(name)}
    with tempfile.NamedTemporaryFile('w', suffix='.yaml') as file:
        yaml.safe_dump(parameters, file)
        file.flush()
        nodes = 'odometry_sweep', 'replay.launch', {'tutorial': tutorial, 'params': file.name}
        return record(nodes, {**robot, 'clock_rate': settings.odom_rate}, end).bag


def metrics_of(bag_file, tutorial, parameters):
    """Return the metrics by name; raise DemoError if the recording contradicts itself."""
    ticks, moved, _ = read(bag_file)
    metrics = follow(run_parameters(tutorial, parameters)[0], ticks, lambda *_: None)
    if tutorial == 'move' and metrics['moved'] not in moved:
        raise DemoError('the detector published another distance')
    return metrics
