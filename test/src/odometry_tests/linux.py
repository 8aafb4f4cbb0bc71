"""What tests ask the system of other processes."""

import contextlib
import uuid

import psutil

from odometry_tests.waiting import wait_until

LOOK_PERIOD = 0.2  # s; each look goes through all processes there are


def new_mark():
    """Return a variable for the environment of processes, by which they are found, as a dictionary."""
    return {'ODOMETRY_UNDER_TEST': str(uuid.uuid4())}


def marked(mark):
    """Return the ids of the processes that have the mark in their environment."""
    (name, value), = mark.items()
    return [process.pid for process in psutil.process_iter(['environ'])
            if (process.info['environ'] or {}).get(name) == value]


def wait_until_none(mark, timeout=15.0):
    """Return once no process has the mark."""
    wait_until(lambda: not marked(mark), timeout,
               lambda: f'the end of\n{command_lines(marked(mark))}', LOOK_PERIOD)


def command_line(pid):
    """Return the command line of a process as a text; empty if it has ended."""
    with contextlib.suppress(psutil.Error):
        return ' '.join(psutil.Process(pid).cmdline())
    return ''


def command_lines(pids):
    """Return the command lines of processes as a text, one in each line."""
    return '\n'.join(map(command_line, pids))
