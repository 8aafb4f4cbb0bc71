"""The check's command line."""

import argparse
import contextlib
import os
import sys
from pathlib import Path

import rospkg
from odometry_common.parameters import StartError
from roslib.packages import find_node, find_resource

from odometry_tools.check.scenarios import EXERCISES


def make_parser():
    """Return the parser of the command line."""
    parser = argparse.ArgumentParser(
        prog='./ws check', allow_abbrev=False, description='Judge a node that you wrote for a tutorial. It runs '
        'unmodified with the simulated robot; the report says what is right and what is not. Exit status '
        '0: all passed; 1: some failed; 2: the check could not run.')
    parser.add_argument('exercise', choices=EXERCISES, help='; '.join(
        f'{name}: it {exercise.task}' for name, exercise in EXERCISES.items()))
    parser.add_argument('node', nargs='+', metavar='NODE',
                        help='PACKAGE NODE, as for rosrun, or PACKAGE and a launch file; a FILE; or '
                             'a FOLDER of files and packages, each judged; then _parameter:=value')
    parser.add_argument('--scenario', metavar='NAME', help='run only this one')
    parser.add_argument('--view', action='store_true',
                        help='show it in a browser, in real time; begins once the page is open')
    parser.add_argument('--junit', metavar='FILE', help='write the verdicts for CI')
    parser.add_argument('--csv', metavar='FILE', help='write a row for each submission and scenario')
    return parser


def parse(arguments):
    """Return the options; exit if they make no sense."""
    parser = make_parser()
    options = parser.parse_args(arguments)
    scenarios = EXERCISES[options.exercise].scenarios
    options.scenarios = [scenario for scenario in scenarios if options.scenario in (None, scenario.name)]
    if not options.scenarios:
        parser.error(f'{options.exercise} has no scenario {options.scenario}, but '
                     f'{", ".join(scenario.name for scenario in scenarios)}')
    options.is_class = len(options.node) == 1 and os.path.isdir(options.node[0])
    if options.view and options.is_class:
        parser.error('--view shows one node, not a folder')
    if options.view and not _is_package('robot_view'):
        parser.error('--view needs the package robot_view')
    return options


def _is_package(name):
    with contextlib.suppress(rospkg.ResourceNotFound):
        return bool(rospkg.RosPack().get_path(name))


def command_of(words):
    """Return the command (a list) that starts a node; raise StartError if there is no such node."""
    first, *others = words
    if os.path.isfile(first):
        path = str(Path(first).resolve())
        return [*([sys.executable] if path.endswith('.py') else []), path, *others]
    if not others:
        raise StartError(f'there is no file or folder {first}; name a file, or PACKAGE NODE')
    node, *others = others
    try:
        nodes = find_node(first, node)
        files = [] if nodes else find_resource(first, node)
    except rospkg.ResourceNotFound:
        raise StartError(f'there is no package {first} in this workspace: is it in .ws/src?') from None
    if nodes:
        return [nodes[0], *others]
    if files and node.endswith('.launch'):
        return ['roslaunch', files[0], *others]
    raise StartError(f'the package {first} has no executable file and no launch file {node}')
