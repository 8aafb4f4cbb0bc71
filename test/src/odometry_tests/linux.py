"""What tests ask of Linux, and not every system offers."""

import contextlib
import os
from pathlib import Path

import pytest
from odometry_launch.keeper import children_by_parent, with_descendants

from odometry_tests.waiting import wait_until

LOOK_PERIOD = 0.2  # s; each look reads what there is of all processes

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


def wait_until_none(mark, timeout=15.0):
    """Return once no process has the mark."""
    wait_until(lambda: not marked(mark), timeout,
               lambda: f'the end of\n{command_lines(marked(mark))}', LOOK_PERIOD)


def command_lines(pids):
    """Return the command lines of processes as a text, one in each line."""
    lines = []
    for pid in pids:
        with contextlib.suppress(OSError):  # it has ended meanwhile
            lines.append(Path(f'/proc/{pid}/cmdline').read_text().replace('\0', ' '))
    return '\n'.join(lines)


def descendants(pid):
    """Return the ids of the processes that a process has started, and that those have."""
    _, *below = with_descendants([pid], children_by_parent())
    return below


def _environment(folder):
    """Return the environment of a process, nothing if it has ended meanwhile."""
    try:
        return (folder / 'environ').read_text(errors='replace').split('\0')
    except OSError:
        return []
