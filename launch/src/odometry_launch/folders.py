"""Folders for what is left of demos and sweeps."""

import itertools
import os
import time
from pathlib import Path

RUNS = Path(os.environ.get('ODOMETRY_RUNS') or Path(__file__).resolve().parents[3] / 'runs')


def new_folder(runs, name=''):
    """Make a folder of this name and moment; another one may have begun in the same second."""
    moment = time.strftime('%Y-%m-%d_%H-%M-%S')
    for suffix in itertools.chain([''], map('_{}'.format, itertools.count(2))):
        folder = Path(runs) / f'{name}{moment}{suffix}'
        try:
            folder.mkdir(parents=True)
        except FileExistsError:
            continue
        return folder
