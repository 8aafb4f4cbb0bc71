"""Which ROS 1 ./ws uses: a table of systems, faked by folders and PATH."""

import shlex

import pytest
from odometry_tests.processes import run
from odometry_tests.scripts import ROOT

SETUP = shlex.quote(str(ROOT / 'tools/setup'))
FIND = f"""
. {SETUP}/system.bash
. {SETUP}/python.bash
USR=$SYSTEM/usr
OPT=$SYSTEM/opt/ros
VENV=$SYSTEM/venv
find_ros
echo "$ROS $PYTHON"
"""
DEBIAN, NOETIC, ONE, MINE = 'usr', 'opt/ros/noetic', 'opt/ros/one', 'mine'
# What is there, which folders' bin are on PATH, what ROS_VERSION says, what the workspace was made
# with; and the choice.
SYSTEMS = {
    'a bare Debian': ('', '', '', '', DEBIAN),
    'its ROS and a workspace sourced': ('usr mine', 'mine usr', '1', '', DEBIAN),
    'noetic sourced, and a workspace': ('opt/ros/noetic mine', 'mine opt/ros/noetic', '1', '', NOETIC),
    "noetic and Debian's": ('opt/ros/noetic usr', 'usr', '', '', NOETIC),
    'ROS One and ROS 2 sourced': ('opt/ros/one', '', '2', '', ONE),
    'ROS One sourced beside noetic': ('opt/ros/one opt/ros/noetic', 'opt/ros/one', '1', '', ONE),
    'noetic sourced too late': ('usr opt/ros/noetic', 'opt/ros/noetic', '1', DEBIAN, DEBIAN),
}


def find_ros(system, path='', status=0, version=''):
    """Run FIND on a system; return its Process."""
    return run('env', '-i', f'SYSTEM={system}', f'PATH={path}{system}/bin', f'ROS_VERSION={version}',
               '/bin/bash', '-euo', 'pipefail', '-c', FIND, status=status)


@pytest.fixture
def system(tmp_path):
    make_programs(tmp_path / 'bin', 'dpkg-query')
    make_programs(tmp_path / 'usr/bin', 'python3')
    return tmp_path


def make_programs(folder, *names):
    folder.mkdir(parents=True, exist_ok=True)
    for name in names:
        (folder / name).symlink_to('/bin/true')


@pytest.mark.parametrize('there, sourced, version, made_with, chosen', SYSTEMS.values(), ids=SYSTEMS)
def test_the_choice(system, there, sourced, version, made_with, chosen):
    """A sourced one, else one in /opt/ros, else Debian's; and always the same one again."""
    for folder in there.split():
        make_programs(system / folder / 'bin', *['catkin_make'] * (folder != MINE))
        (system / folder / 'setup.bash').touch()
    if made_with:
        (system / 'venv').mkdir()
        (system / 'venv/ros').write_text(f'{system}/{made_with}\n{system}/usr/bin/python3\n')
    path = ''.join(f'{system}/{folder}/bin:' for folder in sourced.split())
    found = find_ros(system, path, version=version)
    assert found.stdout.split() == [f'{system}/{chosen}', f'{system}/usr/bin/python3'], found.output


def test_a_system_without_ros_is_told_of_the_container(tmp_path):
    found = find_ros(tmp_path, status=1)
    assert found.output.strip() == './ws: this system has no ROS 1. Use the container: docs/container.md'
