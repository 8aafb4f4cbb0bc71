"""What tests ask of Linux, and not every system offers."""

import contextlib
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


def command_lines(pids):
    """Return the command lines of processes as a text, one in each line."""
    lines = []
    for pid in pids:
        with contextlib.suppress(OSError):  # it has ended meanwhile
            lines.append(Path(f'/proc/{pid}/cmdline').read_text().replace('\0', ' '))
    return '\n'.join(lines)


def descendants(pid):
    """Return the ids of the processes that a process has started, and that those have."""
    children = {}
    for stat in Path('/proc').glob('[0-9]*/stat'):
        with contextlib.suppress(OSError):  # it has ended meanwhile
            parent = stat.read_bytes().rpartition(b')')[2].split()[1]
            children.setdefault(int(parent), []).append(int(stat.parent.name))
    found = list(children.get(pid, []))
    for one in found:
        found += children.get(one, [])
    return found


def _environment(folder):
    """Return the environment of a process, nothing if it has ended meanwhile."""
    try:
        return (folder / 'environ').read_text(errors='replace').split('\0')
    except OSError:
        return []
