"""A campaign: a tutorial, a grid of parameter values, seeds, and limits."""

import difflib
import itertools
import math
from typing import NamedTuple

import yaml
from odometry_common.parameters import ParameterError, StartError
from sim_turtlebot.physics.world_file import WorldFileError
from sim_turtlebot.settings import PARAMETERS, read_settings
from sim_turtlebot.simulation import Simulation

from odometry_sweep.closed_loop import TUTORIALS
from odometry_sweep.launched import LAUNCH, ROBOT, Launched, is_robots
from odometry_sweep.results import METRICS, NOT_ARRIVED, STATISTICS

KEYS = ['tutorial', 'launch', 'until', 'seeds', 'set', 'limits']
MAX_RUNS = 10**6  # the metrics of each run stay in memory
# For windows, wall time, tf, scans, late messages, and nodes that wait or exit. Each run has its seed.
NOT_IN_SWEEPS = {'gui', 'robots', 'clock_rate', 'real_time_factor', 'lockstep', 'paused',
                 'timeout', 'exit_when_done', 'tolerance', 'scan', 'scan_rate', 'scan_beams',
                 'scan_fov', 'scan_range_min', 'scan_range_max', 'scan_noise', 'seed', 'publish_tf'}


class Campaign(NamedTuple):
    """Every combination of parameter values, each with every seed."""

    tutorial: str  # or LAUNCH
    seeds: int  # the seeds are 0 to seeds - 1
    values: dict  # lists by parameter
    limits: dict  # numbers by name
    launched: Launched = None  # what is run in place of a tutorial

    @property
    def combinations(self):
        """An iterator over every combination of the values: dictionaries by parameter."""
        return (dict(zip(self.values, row)) for row in itertools.product(*self.values.values()))

    @property
    def name(self):
        """The tutorial, or the launch file."""
        return self.launched.file if self.launched else self.tutorial

    @property
    def names(self):
        """A label for each combination: the parameters that vary."""
        varied = [name for name, values in self.values.items() if len(values) > 1]
        return [', '.join(f'{name} {combination[name]}' for name in varied) or 'all runs'
                for combination in self.combinations]

    @property
    def count(self):
        """The number of runs."""
        return math.prod(map(len, self.values.values())) * self.seeds

    def runs(self):
        """Yield the parameters of each run: every seed of the first combination, then of the next."""
        for combination in self.combinations:
            for seed in range(self.seeds):
                yield {**combination, 'seed': seed}

    def check(self):
        """Raise StartError, with one line for the user, if the campaign cannot be run."""
        if not self.launched and self.tutorial not in list(TUTORIALS):
            raise StartError(f'the tutorial is {self.tutorial!r}, but must be '
                             f'{" or ".join(TUTORIALS)}')
        if type(self.seeds) is not int or not 1 <= self.seeds <= MAX_RUNS:
            raise StartError(f'seeds is {self.seeds!r}, but must be a whole number from 1 to '
                             f'{MAX_RUNS}')
        if self.launched:
            robot = {name: values for name, values in self.values.items() if is_robots(name)}
            _check_values(self.launched.file, robot, ROBOT)
            self.launched.check({name: self.values[name] for name in self.values.keys() - robot.keys()})
        else:
            _check_values(self.tutorial, self.values, {
                row.name[1:]: row for row in (*TUTORIALS[self.tutorial].PARAMETERS, *PARAMETERS.rows)
                if row.name[1:] not in NOT_IN_SWEEPS})
        if self.count > MAX_RUNS:
            raise StartError(f'there are {self.count} runs, but must be {MAX_RUNS} at most')
        _check_worlds(next(self.combinations), self.values.get('world', []))
        _check_limits(self.tutorial, self.limits)

    def text(self):
        """Return the content of a campaign file."""
        what = ({LAUNCH: [self.launched.package, self.launched.file], 'until': self.launched.until}
                if self.launched else {'tutorial': self.tutorial})
        return yaml.safe_dump({**what, 'seeds': self.seeds, 'set': self.values,
                               'limits': self.limits}, sort_keys=False, allow_unicode=True)


def read_campaign(path):
    """Return the Campaign in a YAML file; raise StartError if it contains none."""
    try:
        with open(path, encoding='utf-8') as file:
            content = yaml.safe_load(file)
    except (OSError, ValueError) as error:
        raise StartError(f'{path} cannot be read: {error}') from None
    except (yaml.YAMLError, RecursionError) as error:
        raise StartError(f'{path} is no YAML: {" ".join(str(error).split())}') from None
    if not isinstance(content, dict) or ('tutorial' in content) == (LAUNCH in content):
        raise StartError(f'{path} names no tutorial, or a launch file, too')
    for key in content:
        if key not in KEYS:
            raise StartError(f'{path} has {key!r}, but may have {", ".join(KEYS)}')
    values, limits = content.get('set') or {}, content.get('limits') or {}
    for key, table in (('set', values), ('limits', limits)):
        if not isinstance(table, dict):
            raise StartError(f'{path}: {key} is {table!r}, but must have a line for each name')
    values = {name: value if isinstance(value, list) else [value] for name, value in values.items()}
    for name, several in values.items():
        if not several:
            raise StartError(f'{path}: {name} has no value')
    return Campaign(content.get('tutorial', LAUNCH), content.get('seeds', 1), values, limits,
                    _launched(path, content))


def _launched(path, content):
    """Return the Launched in the content of a campaign file; None if that has a tutorial."""
    names, until = content.get(LAUNCH, ()), content.get('until')
    if LAUNCH not in content:
        if until is not None:
            raise StartError(f'{path}: until is for a launch file only')
        return None
    if not (isinstance(names, list) and len(names) == 2 and all(isinstance(name, str) for name in names)):
        raise StartError(f'{path}: launch is {names!r}, but must be [package, file]')
    return Launched(*names, until)


def _check_values(what, values, known):
    """Check each value alone: no range depends on another parameter of a sweep.

    :param known: Parameters by name
    """
    for name, several in values.items():
        if name not in known:
            similar = difflib.get_close_matches(name, known, 1)
            hint = f'did you mean {similar[0]}?' if similar else f'it has {", ".join(sorted(known))}'
            raise StartError(f'parameter {name} cannot be set in a sweep of {what}: {hint}')
        for value in several:
            known[name].check(value)


def _check_worlds(combination, worlds):
    """Build each world with the first robot of the sweep in it."""
    for world in filter(None, worlds):
        try:
            Simulation(read_settings({**combination, 'world': world}))
        except WorldFileError as error:
            raise ParameterError('~world', world, error) from None


def _check_limits(tutorial, limits):
    metrics = METRICS[tutorial]
    known = [NOT_ARRIVED, *(f'{metric}_{statistic}' for metric in metrics
                            for statistic in STATISTICS)]
    for name, limit in limits.items():
        if name not in known:
            raise StartError(f'unknown limit {name}; it is {NOT_ARRIVED}, or one of '
                             f'{", ".join(metrics)} followed by one of '
                             f'{", ".join(f"_{statistic}" for statistic in STATISTICS)}')
        if type(limit) not in (int, float) or not limit >= 0:
            raise StartError(f'limit {name} is {limit!r}, but must be a number from 0')
