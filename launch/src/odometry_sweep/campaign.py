"""What is to be run: a tutorial, a grid of parameter values, seeds, and limits."""

import itertools
import math
from typing import NamedTuple

import yaml
from odometry_common.parameters import StartError

from odometry_sweep.limits import check_limits
from odometry_sweep.reading import check_names, check_values
from odometry_sweep.tutorials import TUTORIALS

KEYS = ['tutorial', 'seeds', 'set', 'limits']
MOST_RUNS = 10**6  # the figures of each stay in memory


class CampaignError(StartError):
    """A campaign that cannot be run; the message is one line for the user."""


class Campaign(NamedTuple):
    """The runs that belong together."""

    tutorial: str
    seeds: int  # 0 to one less
    values: dict  # lists by parameter
    limits: dict  # numbers by name

    @property
    def settings(self):
        """Every combination of the values: dictionaries by parameter."""
        return [dict(zip(self.values, row)) for row in itertools.product(*self.values.values())]

    @property
    def varied(self):
        """The parameters that have several values."""
        return [name for name, values in self.values.items() if len(values) > 1]

    @property
    def count(self):
        """How many runs there are."""
        return math.prod(map(len, self.values.values())) * self.seeds

    def runs(self):
        """Yield the parameters of each run: every seed of the first setting, of the second, ..."""
        for setting in self.settings:
            for seed in range(self.seeds):
                yield {**setting, 'seed': seed}

    def check(self):
        """Raise StartError, with one line for the user, if it cannot be run."""
        if self.tutorial not in list(TUTORIALS):
            raise CampaignError(f'the tutorial is {self.tutorial!r}, but must be '
                                f'{" or ".join(TUTORIALS)}')
        whole = isinstance(self.seeds, int) and not isinstance(self.seeds, bool)
        if not whole or not 1 <= self.seeds <= MOST_RUNS:
            raise CampaignError(f'seeds is {self.seeds!r}, but must be a whole number from 1 to '
                                f'{MOST_RUNS}')
        check_names(self.tutorial, self.values)
        if self.count > MOST_RUNS:
            raise CampaignError(f'there are {self.count} runs, but must be {MOST_RUNS} at most')
        for setting in self.settings:
            check_values(self.tutorial, setting)
        check_limits(self.tutorial, self.limits)

    def text(self):
        """Return it as a file has it."""
        return yaml.safe_dump({'tutorial': self.tutorial, 'seeds': self.seeds, 'set': self.values,
                               'limits': self.limits}, sort_keys=False, allow_unicode=True)


def read_campaign(path):
    """Return the Campaign in a YAML file; raise CampaignError if there is none."""
    try:
        with open(path, encoding='utf-8') as file:
            content = yaml.safe_load(file)
    except (OSError, ValueError) as error:
        raise CampaignError(f'{path} cannot be read: {error}') from None
    except (yaml.YAMLError, RecursionError) as error:
        raise CampaignError(f'{path} is no YAML: {" ".join(str(error).split())}') from None
    if not isinstance(content, dict) or 'tutorial' not in content:
        raise CampaignError(f'{path} names no tutorial')
    unknown = [key for key in content if key not in KEYS]
    if unknown:
        raise CampaignError(f'{path} has {unknown[0]!r}, but may have {", ".join(KEYS)}')
    values, limits = (_table(path, content, key) for key in ('set', 'limits'))
    return Campaign(content['tutorial'], content.get('seeds', 1),
                    {name: _as_list(path, name, value) for name, value in values.items()}, limits)


def parse_values(text):
    """Return the name and the values of NAME=VALUE,VALUE; raise ValueError if it is none."""
    name, separator, values = text.partition('=')
    if not separator or not name.isidentifier():
        raise ValueError(f'{text!r} is not NAME=VALUE,VALUE,...')
    try:
        return name, [yaml.safe_load(value) for value in values.split(',')]
    except (yaml.YAMLError, RecursionError):
        raise ValueError(f'{text!r} has a value that is no YAML') from None


def _table(path, content, key):
    table = content.get(key) or {}
    if not isinstance(table, dict):
        raise CampaignError(f'{path}: {key} is {table!r}, but must have a line for each name')
    return table


def _as_list(path, name, value):
    values = value if isinstance(value, list) else [value]
    if not values:
        raise CampaignError(f'{path}: {name} has no value')
    return values
