"""One run of a sweep once more, by the nodes themselves in lockstep, recorded and compared."""

import csv
import itertools
import json
import time

import rospy
from moved_distance.parameters import read_counter
from odometry_common.parameters import read_from
from odometry_common.rospy_fixes import fix_rospy
from odometry_launch.folders import RUNS
from odometry_launch.following import unpause
from odometry_launch.graph import DemoError
from odometry_launch.logs import place_for_logs
from odometry_launch.picture import leave_picture
from odometry_launch.recording import Recording
from sim_turtlebot.settings import read_settings
from straight_drive.parameters import read_drive

from odometry_sweep.campaign import CampaignError, read_campaign
from odometry_sweep.figures import FIGURES
from odometry_sweep.nodes import Nodes
from odometry_sweep.reading import read
from odometry_sweep.recorded import figures_of
from odometry_sweep.results import CAMPAIGN_FILE, FILE
from odometry_sweep.tutorials import Rotate

CONTROLLERS = {'move': ('test_movement', 'test_movement.py', read_drive),
               'rotate': ('rotate_robot', 'rotate.py', Rotate)}
ROBOT = ['odom', 'base_pose_ground_truth']
LONGEST_SILENCE = 60.0  # s of wall time
LOOK_PERIOD = 0.1  # s


def replay(folder, number):
    """Replay the run with this number in the folder of a sweep.

    :raises DemoError: if it does not come out the same, or not at all
    :raises StartError: if there is no such run
    """
    campaign, row, duration = _find(folder, number)
    parameters = next(itertools.islice(campaign.runs(), number - 1, None))
    with place_for_logs(), Nodes() as nodes:
        recording = _record(nodes, campaign.tutorial, parameters, duration)
        bag = recording.close()
    figures = figures_of(recording.path, campaign.tutorial, parameters)
    different = _compare([*FIGURES[campaign.tutorial], 'ended'], row, figures)
    if bag:
        leave_picture(bag)
    if different:
        raise DemoError(f'not the same: {", ".join(different)}')
    print('the same, to the last bit', flush=True)


def _find(folder, number):
    """Return the campaign, the row, a dictionary of texts, and how long the run took (s)."""
    campaign = read_campaign(folder / CAMPAIGN_FILE)
    campaign.check()
    try:
        with open(folder / FILE, newline='', encoding='utf-8') as file:
            rows = list(csv.DictReader(file))
    except (OSError, ValueError, csv.Error) as error:
        raise CampaignError(f'{folder / FILE} cannot be read: {error}') from None
    if not 1 <= number <= len(rows):
        raise CampaignError(f'run {number} is not among the {len(rows)} in {folder / FILE}')
    row = rows[number - 1]
    try:
        return campaign, row, float(row['time'])
    except (KeyError, TypeError, ValueError):
        raise CampaignError(f'run {number} in {folder / FILE} is incomplete') from None


def _compare(names, row, figures):
    """Print both, and return the names of what differs."""
    print(f'{"":16}{"sweep":24}nodes in lockstep')
    for name in names:
        print(f'{name:16}{row[name]:24}{figures[name]}')
    return [name for name in names if row[name] != str(figures[name])]


def _record(nodes, tutorial, parameters, duration):
    """Have the nodes do a run that takes so long (s); return the recording, still open."""
    _, settings = read(tutorial, parameters)
    nodes.start('sim_turtlebot', 'sim_turtlebot_node.py', *_arguments(read_settings, parameters),
                '_real_time_factor:=0', '_lockstep:=true', '_paused:=true',
                f'_clock_rate:={settings.odom_rate}')
    nodes.wait_for(_join, 'the sweep does not become a node')
    recording = Recording(RUNS)
    nodes.wait_for(lambda: recording.hears(*ROBOT), 'the robot does not answer')
    topics = ROBOT
    if tutorial == 'move':
        nodes.start('odom_movement_detector', 'odom_movement_detector.py',
                    *_arguments(read_counter, parameters))
        nodes.wait_for(lambda: recording.hears('moved_distance'), 'the detector does not answer')
        topics = [*ROBOT, 'moved_distance']
    package, script, reader = CONTROLLERS[tutorial]
    # That a machine is busy is no reason for a watchdog to stop a robot in lockstep.
    nodes.start(package, script, *_arguments(reader, parameters), '_timeout:=0')
    nodes.wait_for(lambda: recording.hears('cmd_vel'), 'the controller does not answer')
    nodes.wait_for(unpause, 'the robot does not begin')
    enough = round(duration * settings.odom_rate) + 1
    _wait_for(lambda: min(map(recording.count, topics)), enough, nodes)
    return recording


def _join():
    fix_rospy()
    rospy.init_node('sweep', anonymous=True, disable_signals=True)
    return True


def _arguments(reader, parameters):
    """Return those of the parameters that a function reads, as a node's arguments."""
    with read_from({}) as asked:
        reader()
    # JSON is YAML, as which a node reads them.
    return [f'_{name}:={json.dumps(parameters[name])}' for name in parameters if name in asked]


def _wait_for(count, enough, nodes):
    """Return once there are enough messages; raise DemoError when no more come."""
    last, changed = 0, time.monotonic()
    while (now := count()) < enough:
        nodes.check()
        if now > last:
            last, changed = now, time.monotonic()
        elif time.monotonic() - changed > LONGEST_SILENCE:
            raise DemoError(f'nothing was recorded for {LONGEST_SILENCE:g} s')
        time.sleep(LOOK_PERIOD)
