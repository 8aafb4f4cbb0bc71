"""Runs by nodes in lockstep, and their metrics from the bag."""

import csv
import itertools
import math
from pathlib import Path

import numpy
import rosbag
import yaml
from nav_msgs.msg import Odometry
from odometry_common.parameters import StartError
from odometry_common.rest import is_slow
from sim_turtlebot.settings import read_settings
from std_msgs.msg import Float64

from odometry_tools.runs.bags import read_messages
from odometry_tools.runs.folders import use_writable_logs
from odometry_tools.runs.output import RunError, complain
from odometry_tools.runs.recorded_run import read_run
from odometry_tools.runs.recording import leave_picture
from odometry_tools.runs.session import Session
from odometry_tools.runs.tutorials import TUTORIALS, degrees, follow, motion_in
from odometry_tools.sweep.campaign import read_campaign
from odometry_tools.sweep.node_run import record
from odometry_tools.sweep.results import CAMPAIGN_FILE, FILE, METRICS
from odometry_tools.sweep.subjects import LAUNCH, ROBOT


def replay(folder, number):
    """Repeat the run with a number (a string) in the folder of a sweep, and compare.

    :raises RunError: if the result differs, or there is none
    :raises StartError: if there is no such run
    """
    campaign = read_campaign(Path(folder, CAMPAIGN_FILE)).checked()
    subject, names = campaign.subject, [*METRICS[campaign.subject.kind], 'ended']
    try:
        with open(Path(folder, FILE), newline='', encoding='utf-8') as file:
            row, = (row for row in csv.DictReader(file) if row['run'] == number)
        kept = {name: row[name] for name in names}
        if None in kept.values():
            raise ValueError('the row ends early')
        parameters = next(itertools.islice(campaign.runs(), int(number) - 1, None))
    except (OSError, KeyError, ValueError, StopIteration, csv.Error):
        raise StartError(
            f'{Path(folder, FILE)} has no run {number}, or only a part of it') from None
    use_writable_logs()
    with Session() as session:
        metrics, bag, targets = run_nodes(session, subject, parameters)
    if why := metrics.get('why'):
        complain(why)
    print(f'{f"run {number}":16}{"sweep":24}nodes in lockstep')
    for name in names:
        print(f'{name:16}{kept[name]:24}{metrics[name]}')
    leave_picture(bag, **targets)
    different = [name for name in names if kept[name] != str(metrics[name])]
    if different:
        raise RunError(f'not the same: {", ".join(different)}')
    print('the same, to the last bit', flush=True)


def run_nodes(session, subject, parameters, folder=None):
    """Record nodes in a Session, in a folder (a Path) or in a new one.

    :return: the metrics by name, the path of the bag, and targets as for leave_picture()
    :raises RunError: if the recording contradicts itself
    """
    robot = {name: value for name, value in parameters.items() if name in ROBOT}
    seed = robot.pop('seed')
    if subject.kind == LAUNCH:
        session.simulate(robot)
        bag, ended, why = record(session, subject.nodes(parameters), seed, subject.until, folder)
        return {**_launch_metrics(bag), 'ended': ended, 'why': why}, bag, {}
    robot['clock_rate'] = read_settings(parameters).odom_rate  # these nodes need no finer one
    session.simulate(robot)
    line = yaml.safe_dump(parameters, default_flow_style=True, width=math.inf).strip()
    nodes = 'odometry_tools', 'replay.launch', {'tutorial': subject.kind, 'params': line}
    bag, *_ = record(session, nodes, seed, subject.run(parameters)['time'], folder)
    targets = TUTORIALS[subject.kind](parameters).targets
    return tutorial_metrics(subject.kind, parameters, bag), bag, targets


def tutorial_metrics(kind, parameters, path):
    """Return what a tutorial's loop measures in a bag; RunError: its nodes did something else."""
    with rosbag.Bag(str(path)) as bag:
        odometry, ground_truth, moved = (
            [message for _, message, _ in read_messages(bag, kind, topic)]
            for kind, topic in ((Odometry, '/odom'), (Odometry, '/base_pose_ground_truth'),
                                (Float64, '/moved_distance')))
    for messages in (odometry, ground_truth):
        numbers = [message.header.seq for message in messages]
        if not messages or numbers != [*range(len(messages))]:
            raise RunError('the recording has gaps')
    ticks = ((seen.header.stamp.to_sec(), motion_in(seen), motion_in(true))
             for seen, true in zip(odometry, ground_truth))
    metrics = follow(TUTORIALS[kind](parameters), ticks, lambda *_: None)
    if kind == 'move' and metrics['moved'] not in [message.data for message in moved]:
        raise RunError('the detector published another distance')
    return metrics


def _launch_metrics(bag):
    run = read_run(bag)
    truth, error = run.ground_truth, run.error
    start, end = (truth.at(time) for time in truth.time[[0, -1]])
    travel = start.inverse().then(end)
    # An earlier command is ignored, and lost unless its connection has been made by then.
    commands = numpy.count_nonzero(run.commands[:, 0] > 0)
    is_moving = ~is_slow(truth.speed, truth.turn_rate)
    return {
        'distance': truth.distance[-1],
        'from_start': math.hypot(travel.x, travel.y),
        'sideways': travel.y,
        'heading': math.degrees(travel.yaw),
        'heading_error': degrees(error.yaw),
        'odometry_error': math.hypot(error.x, error.y),
        'time': truth.time[is_moving].max(initial=0.0),
        'commands': commands}
