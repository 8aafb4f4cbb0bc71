"""The check's command line."""

import argparse
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

import rospkg
from odometry_common.parameters import StartError
from roslib.packages import find_node, find_resource

from odometry_tools.check.scenarios import EXERCISES
from odometry_tools.runs.plain_text import plain
from odometry_tools.runs.quoting import how_ended

ELF = b'\x7fELF'  # how a compiled program begins
LONGEST_LINE = 256  # bytes that Linux reads of a #! line
# Not with python3 -m, which imports from the folder where the user stands.
CHECK_LAUNCH_FILE = ('import sys; sys.path[:] = filter(None, sys.path); '
                     'from odometry_tools.runs.launch_files import main; main()')


class Program(NamedTuple):
    """A command that starts a node."""

    command: list
    environment: tuple = ()  # pairs of name and value, added to ours


def make_parser():
    """Return the parser of the command line."""
    parser = argparse.ArgumentParser(
        prog='./ws check', allow_abbrev=False,
        description='Judge a node that you wrote for a tutorial. It runs unmodified with the '
        'simulated robot; the report says what is right and what is not. '
        'Exit status 0: all passed; 1: some failed; 2: the check could not run.')
    parser.add_argument('exercise', choices=EXERCISES, help='; '.join(
        f'{name}: it {exercise.task}' for name, exercise in EXERCISES.items()))
    parser.add_argument('node', nargs='+', metavar='NODE',
                        help='PACKAGE NODE, as for rosrun, or PACKAGE and a launch file; '
                             'a FILE or the folder of a package; or a FOLDER of files and '
                             'packages, each judged; then _parameter:=value')
    parser.add_argument('--scenario', metavar='NAME', help='run only this one')
    parser.add_argument('--view', action='store_true',
                        help='show it in a browser, in real time; begins once the page is open')
    parser.add_argument('--junit', metavar='FILE', help='write the verdicts for CI')
    parser.add_argument('--csv', metavar='FILE',
                        help='write a row for each submission and scenario')
    return parser


def parse(arguments):
    """Return the options; exit with a message if they are invalid."""
    parser = make_parser()
    options = parser.parse_args(arguments)
    scenarios = EXERCISES[options.exercise].scenarios
    options.scenarios = [scenario for scenario in scenarios
                         if options.scenario in (None, scenario.name)]
    if not options.scenarios:
        parser.error(f'{options.exercise} has no scenario {options.scenario}, but '
                     f'{", ".join(scenario.name for scenario in scenarios)}')
    folder = Path(options.node[0])
    options.is_class = len(options.node) == 1 and folder.is_dir() and not is_package(folder)
    if options.view and options.is_class:
        parser.error('--view shows one node, not a folder')
    return options


def is_package(path):
    """Return whether a Path is the folder of a package."""
    return (path / 'package.xml').is_file()


def program_of(words):
    """Return the Program that starts a node; raise StartError if there is no such node."""
    first, *others = words
    path = Path(first).resolve()
    if is_package(path) and all(':=' in word for word in others):
        paths = filter(None, [str(path / 'src'), os.environ.get('PYTHONPATH')])
        environment = (('PYTHONPATH', os.pathsep.join(paths)),)
        return Program(_command_of(_node_of(path), others), environment)
    if path.is_file():
        if files := [word for word in others if word.endswith('.py')]:
            raise StartError(f'{files[0]} is a second file: judge one, or a folder of them')
        return Program(_command_of(path, others))
    if not others:
        raise StartError(f'there is no file or folder {first}; name a file, or PACKAGE NODE')
    node, *others = others
    try:
        found = find_node(first, node) or node.endswith('.launch') and find_resource(first, node)
    except rospkg.ResourceNotFound:
        raise StartError(
            f'there is no package {first} in this workspace: is it in .ws/src?') from None
    if not found:
        raise StartError(f'the package {first} has no executable file and no launch file {node}; '
                         'chmod +x makes a file executable')
    return Program(_command_of(Path(found[0]), others))


def _command_of(path, arguments):
    """Return the command (a list) that starts a file."""
    if path.suffix == '.launch':
        _check_launch_file(path, arguments)
        return ['roslaunch', str(path), *arguments]
    if _is_python(path) and not os.access(path, os.X_OK):
        return [sys.executable, str(path), *arguments]
    _check_first_line(path)
    return [str(path), *arguments]


def _check_launch_file(path, arguments):
    """Raise StartError if a launch file cannot run beside a robot.

    Another process reads it, since roslaunch runs Python code in it: $(eval ...), and rad(...).
    """
    reader = subprocess.run([sys.executable, '-c', CHECK_LAUNCH_FILE, str(path), *arguments],
                            check=False, capture_output=True, text=True, errors='replace')
    if reader.returncode:
        *_, said = plain(reader.stderr).strip().split('\n')
        raise StartError(said or f'{path.name} ends the process that reads it, '
                                 f'{how_ended(reader.returncode)}')


def _check_first_line(path):
    """Raise StartError if the system cannot start a script; its own errors do not say why."""
    line = _first_line(path)
    if line.startswith(ELF):
        return
    first, words = f'the first line of {path.name}', line[2:].split()
    if not (line.startswith(b'#!') and words):
        raise StartError(f'{first} must be #!/usr/bin/env python3, so that it can be executed')
    if line.endswith(b'\r\n'):
        raise StartError(f'{first} ends as on Windows: '
                         f'sed -i "s/\\r$//" {shlex.quote(str(path))}')
    if not os.path.exists(words[0]):
        raise StartError(f'{first} names {os.fsdecode(words[0])}, which is not on this machine')


def _node_of(package):
    """Return the node of a package: its only executable Python file, or its only Python file."""
    files = [path for path in sorted(package.rglob('*'))
             if path.name not in ('setup.py', '__init__.py') and _is_python(path)]
    files = [path for path in files if os.access(path, os.X_OK)] or files
    if len(files) != 1:
        raise StartError(
            f'{len(files)} Python files could be the node of {package.name}: '
            'say PACKAGE NODE, with the package in .ws/src')
    return files[0]


def _is_python(path):
    """Return whether a file is a Python program, by its name or, if that has no suffix, its #!."""
    if path.suffix or not path.is_file():
        return path.suffix == '.py'
    return bool(re.match(rb'#!.*python', _first_line(path)))


def _first_line(path):
    with path.open('rb') as file:
        return file.readline(LONGEST_LINE)
