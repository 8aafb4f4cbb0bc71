"""Repeat one run of a sweep with the nodes in lockstep, record it, and compare the metrics."""

import csv
import itertools
import tempfile
import time
from pathlib import Path

import rosbag
import rospy
import yaml
from odometry_common.parameters import StartError
from odometry_launch.folders import use_writable_logs
from odometry_launch.following import join, unpause
from odometry_launch.launch import Launch
from odometry_launch.output import DemoError
from odometry_launch.recording import Recording, leave_picture
from sim_turtlebot.robot.odometry import Motion

from odometry_sweep.campaign import read_campaign
from odometry_sweep.closed_loop import follow, run_parameters
from odometry_sweep.results import CAMPAIGN_FILE, FILE, METRICS, read_rows

TOPICS = {'move': ['odom', 'base_pose_ground_truth', 'moved_distance', 'cmd_vel'],
          'rotate': ['odom', 'base_pose_ground_truth', 'cmd_vel']}
CHECK_PERIOD = 0.1  # s


def replay(folder, number):
    """Replay the run with a number (a string) in the folder of a sweep.

    :raises DemoError: if the result differs, or there is none
    :raises StartError: if there is no such run
    """
    tutorial, parameters, row, end = _find(Path(folder), number)
    bag = _record(tutorial, parameters, end)
    metrics = metrics_of(bag, tutorial, parameters)
    print(f'{"":16}{"sweep":24}nodes in lockstep')
    for name in (names := [*METRICS[tutorial], 'ended']):
        print(f'{name:16}{row[name]:24}{metrics[name]}')
    leave_picture(bag, **run_parameters(tutorial, parameters)[0].targets)
    different = [name for name in names if row[name] != str(metrics[name])]
    if different:
        raise DemoError(f'not the same: {", ".join(different)}')
    print('the same, to the last bit', flush=True)


def _find(folder, number):
    """Return tutorial and parameters of a run, its row of strings, and its duration (s)."""
    campaign = read_campaign(folder / CAMPAIGN_FILE)
    campaign.check()
    try:
        row = {row['run']: row for row in read_rows(folder)}[number]
        parameters = next(itertools.islice(campaign.runs(), int(number) - 1, None))
        return campaign.tutorial, parameters, row, float(row['time'])
    except (OSError, KeyError, TypeError, ValueError, StopIteration, csv.Error):
        raise StartError(f'{folder / FILE} has no run {number}, or only a part of it') from None


def _record(tutorial, parameters, end):
    """Run the nodes until a simulated time (s), and record them; return the path of the bag."""
    _, settings = run_parameters(tutorial, parameters)
    use_writable_logs()
    with tempfile.NamedTemporaryFile('w', suffix='.yaml') as file:
        yaml.safe_dump(parameters, file)
        file.flush()
        arguments = {'tutorial': tutorial, 'odom_rate': settings.odom_rate, 'params': file.name}
        with Launch('replay.launch', arguments, package='odometry_sweep') as launch:
            join(launch, 'sweep')
            recording = Recording()
            launch.wait_for(lambda: recording.is_connected(*TOPICS[tutorial]),
                            'the nodes do not answer')
            launch.wait_for(unpause, 'the robot stays paused')
            _wait_for_time(end, launch)
            recording.close()
    return recording.path


def _wait_for_time(end, launch):
    """Return after simulated time `end` (s); in lockstep all messages up to it are then recorded."""
    while rospy.get_time() <= end:
        launch.check()
        time.sleep(CHECK_PERIOD)


def metrics_of(bag_file, tutorial, parameters):
    """Return the metrics by name; raise DemoError if the recording contradicts itself."""
    try:
        with rosbag.Bag(str(bag_file)) as bag:
            odometry, ground_truth, moved = (
                [message for _, message, _ in bag.read_messages(topic)]
                for topic in ('/odom', '/base_pose_ground_truth', '/moved_distance'))
    except (OSError, rosbag.ROSBagException) as error:
        raise DemoError(f'{bag_file} cannot be read: {error}') from None
    ticks = [(seen.header.stamp.to_sec(), _motion(seen), _motion(true))
             for seen, true in zip(_in_order(odometry), _in_order(ground_truth))]
    metrics = follow(run_parameters(tutorial, parameters)[0], ticks, lambda *_: None)
    if tutorial == 'move' and metrics['moved'] not in [message.data for message in moved]:
        raise DemoError('the detector published another distance')
    return metrics


def _in_order(messages):
    """Return the messages; raise DemoError if one is missing."""
    if not messages or [message.header.seq for message in messages] != [*range(len(messages))]:
        raise DemoError('the recording has gaps')
    return messages


def _motion(message):
    pose, twist = message.pose.pose, message.twist.twist
    position, orientation, linear, angular = (
        tuple(getattr(part, name) for name in part.__slots__)
        for part in (pose.position, pose.orientation, twist.linear, twist.angular))
    return Motion(position, orientation, linear, angular)
