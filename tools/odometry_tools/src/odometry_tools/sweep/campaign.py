"""A campaign: a tutorial or a launch file, a grid of parameter values, seeds, and limits."""

import itertools
import math
import os
from typing import Any, NamedTuple

import yaml
from odometry_common.parameters import Parameter, ParameterError, StartError
from sim_turtlebot.physics.world_file import WorldFileError, left_out
from sim_turtlebot.settings import read_settings
from sim_turtlebot.simulation import Simulation

from odometry_tools.runs.output import complain
from odometry_tools.sweep.results import METRICS, NOT_ARRIVED, STATISTICS
from odometry_tools.sweep.subjects import LAUNCH, Launched, Tutorial, choose

MAX_RUNS = 10**6  # the metrics of each run stay in memory
SEEDS = Parameter('seeds', 1, '', '', f'from 1 to {MAX_RUNS}')


class Campaign(NamedTuple):
    """Every combination of parameter values, each with every seed."""

    subject: Any  # a Tutorial or a Launched
    seeds: int  # the seeds are 0 to seeds - 1
    values: dict  # lists by parameter
    limits: dict  # numbers by name

    @property
    def combinations(self):
        """An iterator over every combination of the values: dictionaries by parameter."""
        rows = itertools.product(*self.values.values())
        return (dict(zip(self.values, row)) for row in rows)

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
        """Yield the parameters of each run: each seed of the first combination, then the next."""
        for combination in self.combinations:
            for seed in range(self.seeds):
                yield {**combination, 'seed': seed}

    def checked(self):
        """Return the campaign with its numbers converted: YAML reads 1e-2 as a string.

        :raises StartError: with one line for the user, if the campaign cannot be run
        """
        campaign = self._replace(seeds=SEEDS.check(self.seeds))
        if not 1 <= campaign.count <= MAX_RUNS:
            raise StartError(f'there are {campaign.count} runs, but must be 1 to {MAX_RUNS}')
        subject = self.subject.checked(self.values)
        self._check_worlds()
        known = dict.fromkeys([NOT_ARRIVED, *(
            f'{metric}_{name}' for metric in METRICS[subject.kind] for name in STATISTICS)])
        for name in self.limits:
            choose(name, known, f'unknown limit {name}')
        limits = {name: Parameter(f'limit {name}', 0.0, '', '', 'from 0').check(limit)
                  for name, limit in self.limits.items()}
        return campaign._replace(subject=subject, limits=limits)

    def _check_worlds(self):
        """Raise StartError if the first robot of the sweep cannot be in one of the worlds."""
        for world in filter(None, self.values.get('world', [])):
            try:
                Simulation(read_settings({**next(self.combinations), 'world': world}))
            except WorldFileError as error:
                raise ParameterError('~world', world, error) from None
            if warning := left_out(world):
                complain(warning)


def read_campaign(path):
    """Return the Campaign in a YAML file; raise StartError if it contains none."""
    try:
        with open(path, encoding='utf-8') as file:
            content = yaml.safe_load(file)
    except (OSError, ValueError, yaml.YAMLError, RecursionError) as error:
        raise StartError(f'{path} cannot be read: {" ".join(str(error).split())}') from None
    if not isinstance(content, dict):
        raise StartError(f'{path} names no tutorial and no launch file')
    kind = Launched if LAUNCH in content else Tutorial
    for key in content:
        choose(key, dict.fromkeys([*kind._fields, 'seeds', 'set', 'limits']), f'{path} has {key!r}')
    values, limits = content.get('set') or {}, content.get('limits') or {}
    for key, table in (('set', values), ('limits', limits)):
        if not isinstance(table, dict):
            raise StartError(f'{path}: {key} is {table!r}, but must have a line for each name')
    values = {name: value if isinstance(value, list) else [value] for name, value in values.items()}
    return Campaign(kind(*map(content.get, kind._fields)), content.get('seeds', 1),
                    absolute_worlds(values), limits)


def absolute_worlds(values):
    """Return the values with absolute world paths: nodes and a replay run in other folders."""
    worlds = [os.path.abspath(world) if world and isinstance(world, str) else world
              for world in values.get('world', [])]
    return {**values, 'world': worlds} if worlds else values
