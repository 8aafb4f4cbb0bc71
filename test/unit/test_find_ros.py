"""Which ROS 1 ./ws decides to use: a table of systems, faked by folders and PATH."""

import shlex
import subprocess

import pytest
from odometry_tests.scripts import ROOT

SCRIPTS = shlex.quote(str(ROOT / 'launch' / 'scripts'))
FIND = f"""
. {SCRIPTS}/install.bash
. {SCRIPTS}/find_ros.bash
USR=$SYSTEM/usr
OPT=$SYSTEM/opt/ros
VENV=$SYSTEM/venv
find_ros
echo "$ROS $PYTHON"
"""
FOLDERS = {'debian': 'usr', 'noetic': 'opt/ros/noetic', 'one': 'opt/ros/one',
           'humble': 'opt/ros/humble', 'conda': 'home/conda', 'built': 'home/ros/install',
           'mine': 'home/ws/devel'}
# What is there, what ROS_VERSION says, whose bin is on PATH, what the workspace was made with; and
# which is to be chosen.
SYSTEMS = {
    'a bare Debian': ('dpkg', '', '', '', 'debian'),
    'Debian, its ROS installed': ('dpkg debian', '', '', '', 'debian'),
    'a workspace sourced on it': ('dpkg debian mine', '1', 'mine debian', '', 'debian'),
    './ws shell on it': ('dpkg debian mine', '1', 'mine debian', 'debian', 'debian'),
    'its variable alone': ('dpkg', '1', '', '', 'debian'),
    'noetic': ('dpkg noetic', '', '', '', 'noetic'),
    'noetic sourced': ('dpkg noetic', '1', 'noetic', '', 'noetic'),
    './ws shell on noetic': ('dpkg noetic mine', '1', 'mine noetic', 'noetic', 'noetic'),
    "noetic and Debian's": ('dpkg noetic debian', '', 'debian', '', 'noetic'),
    "a workspace sourced on Debian's, and noetic": (
        'dpkg noetic debian mine', '1', 'mine debian', '', 'noetic'),
    'ROS One': ('dpkg one', '', '', '', 'one'),
    'ROS One and noetic': ('dpkg one noetic', '', '', '', 'noetic'),
    'ROS One sourced beside noetic': ('dpkg one noetic', '1', 'one', '', 'one'),
    'ROS One and ROS 2 sourced': ('dpkg one humble', '2', 'humble', '', 'one'),
    'Debian and ROS 2 sourced': ('dpkg humble', '2', 'humble', '', 'debian'),
    'ROS 2 of conda': ('dpkg conda', '2', 'conda', '', 'debian'),
    'RoboStack activated': ('dpkg conda', '1', 'conda', '', 'conda'),
    'RoboStack on Fedora': ('conda', '1', 'conda', '', 'conda'),
    'RoboStack beside noetic': ('dpkg noetic conda', '1', 'conda', '', 'conda'),
    'RoboStack not activated': ('dpkg conda', '', '', '', 'debian'),
    'RoboStack not activated any more': ('conda', '', '', 'conda', 'conda'),
    'RoboStack activated too late': ('dpkg debian conda', '1', 'conda', 'debian', 'debian'),
    'RoboStack removed': ('dpkg', '', '', 'conda', 'debian'),
    'built from source': ('built', '1', 'built', '', 'built'),
    'built from source, of a workspace': ('built mine', '1', 'mine built', '', 'built'),
    'Fedora': ('', '', '', '', None),
    'Fedora with ROS 2': ('humble', '2', 'humble', '', None),
    'Fedora, RoboStack not activated': ('conda', '', '', '', None),
}


def make_program(path, content=''):
    """Make a program that does nothing, or what the content says."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(f'#!/bin/sh\n{content}\n')
    path.chmod(0o755)


def make_system(folder, there):
    """Make what there is of a system."""
    make_program(folder / 'usr' / 'bin' / 'python3', 'exit 1')
    for name in there:
        if name == 'dpkg':
            make_program(folder / 'bin' / 'dpkg-query')
            continue
        place = folder / FOLDERS[name]
        make_program(place / 'setup.bash')
        if name not in ('humble', 'mine'):
            make_program(place / 'bin' / 'catkin_make')
        if name in ('conda', 'built'):
            knows = '=' if name == 'conda' else '!='
            make_program(place / 'bin' / 'python3', f'[ "$2" {knows} "import rospy" ]')


def python_of(name):
    """Return the Python that is to go with a ROS."""
    return f'{FOLDERS["conda" if name == "conda" else "debian"]}/bin/python3'


@pytest.mark.parametrize('system', SYSTEMS)
def test_the_choice(tmp_path, system):
    """One that is sourced, else one in /opt/ros, else Debian's; and always the same one again."""
    there, version, sourced, remembered, chosen = SYSTEMS[system]
    make_system(tmp_path, there.split())
    (tmp_path / 'venv').mkdir()
    if remembered:
        (tmp_path / 'venv' / 'ros').write_text(
            f'{tmp_path}/{FOLDERS[remembered]}\n{tmp_path}/{python_of(remembered)}\n')
    path = ''.join(f'{tmp_path}/{FOLDERS[name]}/bin:' for name in sourced.split())
    variables = {'SYSTEM': str(tmp_path), 'ROS_VERSION': version, 'PATH': f'{path}{tmp_path}/bin'}
    run = subprocess.run(['/bin/bash', '-euo', 'pipefail', '-c', FIND], env=variables, check=False,
                         capture_output=True, text=True)
    if chosen:
        found = [f'{tmp_path}/{FOLDERS[chosen]}', f'{tmp_path}/{python_of(chosen)}']
        assert run.stdout.split() == found, run.stderr
    else:
        assert (run.returncode, run.stdout) == (1, '')
        assert run.stderr == ('./ws: this system has no ROS 1. Here, as anywhere, the container '
                              'runs: docs/container.md\n')
