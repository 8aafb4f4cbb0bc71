"""What tests ask of Linux, and not every system offers."""

import os
from pathlib import Path

import pytest

needs_children = pytest.mark.skipif(
    not Path(f'/proc/self/task/{os.getpid()}/children').exists(),
    reason='this system does not list the children of a process in /proc')


def marked(mark):
    """Return the ids of the processes that have a variable in their environment.

    :param mark: a dictionary of its name and its value
    """
    (name, value), = mark.items()
    return [int(folder.name) for folder in Path('/proc').glob('[0-9]*')
            if f'{name}={value}' in _environment(folder)]


def _environment(folder):
    """Return the environment of a process, nothing if it has ended meanwhile."""
    try:
        return (folder / 'environ').read_text(errors='replace').split('\0')
    except OSError:
        return []
