"""A run of the nodes in somebody's launch file, in a process of its own."""

import concurrent.futures
import contextlib
import difflib
import math
import multiprocessing
import os
import tempfile
from pathlib import Path
from typing import NamedTuple

from odometry_common.parameters import StartError
from odometry_launch.arrival import REST_ANGULAR_SPEED, REST_SPEED
from sim_turtlebot.settings import PARAMETERS

from odometry_sweep.closed_loop import ARRIVED, LATE, UNTIL, degrees, planar_pose

LAUNCH = 'launch'  # in place of a tutorial
CRASHED, NOT_AWAITED = 'crashed', 'not awaited'
# The sweep decides how time goes on, and has a window for nobody.
NOT_FOR_ROBOTS = {'gui', 'robots', 'real_time_factor', 'lockstep', 'paused', 'seed'}
ROBOT = {row.name[1:]: row for row in PARAMETERS.rows if row.name[1:] not in NOT_FOR_ROBOTS}
MAX_UNTIL = 1e5  # s


class Launched(NamedTuple):
    """A launch file, and when its runs end."""

    package: str
    file: str
    until: float  # s of simulated time

    def check(self, values):
        """Raise StartError if this cannot run with these arguments (lists by name)."""
        import roslaunch
        from odometry_launch.launch import load, path_of
        from roslaunch.arg_dump import get_args
        if type(self.until) not in (int, float) or not 0 < self.until <= MAX_UNTIL:
            raise StartError(f'until is {self.until!r}, but must be s of simulated time, up to {MAX_UNTIL:g}')
        try:
            known = get_args([path_of(self.package, self.file)])
            for name in values:
                if name not in known:
                    similar = difflib.get_close_matches(name, known, 1)
                    hint = (f'did you mean {similar[0]}?' if similar else
                            f'it has {", ".join(sorted(known)) or "none"}')
                    raise StartError(f'{self.file} has no argument {name}, nor has the robot: {hint}')
            first = {name: several[0] for name, several in values.items()}
            nodes = load([(self.package, self.file, arguments_of(first))]).nodes
        except roslaunch.RLException as error:
            raise StartError(f'{self.file}: {" ".join(str(error).split())}') from None
        if any(node.package == 'sim_turtlebot' and node.type == 'sim_turtlebot_node.py' for node in nodes):
            raise StartError(f'{self.file} starts a robot, but the sweep does that: leave out sim.launch')
        if not nodes:
            raise StartError(f'{self.file} starts no node')

    def run(self, parameters):
        """Run in a process of its own, since rospy begins only once; return the metrics by name."""
        context = multiprocessing.get_context('forkserver')  # a Dask worker has threads
        context.set_forkserver_preload(['odometry_sweep.recorded', 'odometry_launch.stepping'])
        with concurrent.futures.ProcessPoolExecutor(1, context) as executor:
            return executor.submit(run_alone, self, parameters).result()

    def record(self, parameters, folder=None):
        """Run in this process; return the metrics, and the path of the bag in a folder or a new one."""
        from odometry_launch.stepping import record

        from odometry_sweep.recorded import read
        arguments = arguments_of({name: value for name, value in parameters.items() if not is_robots(name)})
        robot = {name: value for name, value in parameters.items() if is_robots(name)}
        recorded = record((self.package, self.file, arguments), robot, self.until, folder,
                          are_watched=False)
        ticks, _, commands = read(recorded.bag)
        return {**_metrics(ticks), 'commands': commands, 'ended': _ended(recorded)}, recorded.bag


def is_robots(name):
    """Return whether a parameter is the simulator's."""
    return f'~{name}' in PARAMETERS.names


def arguments_of(values):
    """Return values as roslaunch reads them."""
    return {name: str(value).lower() if isinstance(value, bool) else value
            for name, value in values.items()}


def _ended(recorded):
    """Return why a run ended: one of ARRIVED, LATE, UNTIL, CRASHED, NOT_AWAITED."""
    if any(status != 0 for status in recorded.statuses.values()):
        return CRASHED
    if recorded.unawaited:
        return NOT_AWAITED
    if not recorded.required:
        return UNTIL
    return ARRIVED if recorded.required <= recorded.statuses.keys() else LATE


def _metrics(ticks):
    """Return the metrics by name, from ticks as for closed_loop.follow()."""
    times, odometry, truth = zip(*ticks)
    poses = [planar_pose(motion) for motion in truth]
    travel, seen = (planar_pose(motions[0]).inverse().then(planar_pose(motions[-1]))
                    for motions in (truth, odometry))
    moving = [time for time, motion in zip(times, truth)
              if math.hypot(*motion.linear[:2]) > REST_SPEED
              or abs(motion.angular[2]) > REST_ANGULAR_SPEED]
    return {'distance': math.fsum(math.dist(before[:2], after[:2])
                                  for before, after in zip(poses, poses[1:])),
            'from_start': math.hypot(travel.x, travel.y), 'sideways': travel.y,
            'heading': degrees(travel.yaw), 'heading_error': degrees(seen.yaw - travel.yaw),
            'odometry_error': math.dist(seen[:2], travel[:2]), 'time': max(moving, default=0.0)}


def run_alone(launched, parameters):
    """Run in this process, and leave no file; return the metrics by name."""
    with tempfile.TemporaryDirectory() as folder, open(os.devnull, 'w', encoding='utf-8') as nowhere:
        os.environ['ROS_LOG_DIR'] = folder  # else each run leaves one
        with contextlib.redirect_stdout(nowhere):
            metrics, _ = launched.record(parameters, Path(folder))
    return metrics
