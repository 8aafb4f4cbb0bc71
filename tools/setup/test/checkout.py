"""What looks like a checkout of this project, with a package of the user's, for ./ws to set up."""

import os
import shutil

from odometry_tests.processes import run
from odometry_tests.scripts import ROOT

MANIFEST = """<package format="3">
  <name>{name}</name>
  <version>1.0.0</version>
  <description>A package of the user's own.</description>
  <maintainer email="me@example.com">Me</maintainer>
  <license>BSD</license>
  <buildtool_depend>catkin</buildtool_depend>
</package>
"""
# As teleop_twist_keyboard has it: CMake then looks for compilers.
CMAKE = """cmake_minimum_required(VERSION 3.0.2)
project({name})
find_package(catkin REQUIRED)
catkin_package()
catkin_install_python(PROGRAMS hello.py DESTINATION ${{CATKIN_PACKAGE_BIN_DESTINATION}})
"""
HELLO = """#!/usr/bin/env python3
import {module}
print("hello from", {module}.__name__)
"""
TIMEOUT = 60.0  # s
START = """
set -euo pipefail
. "$CHECKOUT/tools/setup/set_up.bash"
"""
# The set-up of a few packages, with the virtual environment of this project.
FASTER = """
has_requirements() { true; }
PACKAGES=(odometry_common test_movement)
"""
RUN_MINE = FASTER + """
set_up true
set +u
. "$WORKSPACE/devel/setup.bash"
rosrun mine hello.py
echo "$CMAKE_PREFIX_PATH $ROS_PACKAGE_PATH"
"""


def make_checkout(folder, made=('.venv',)):
    """Make it of links to this project's files, and to that of what ./ws makes which is named."""
    folder.mkdir(parents=True)
    for path in ROOT.iterdir():
        if path.name in made or path.name not in ('.venv', '.ws', 'runs', 'ws', 'test_movement'):
            (folder / path.name).symlink_to(path)
    # A link would lead ./ws elsewhere, and this package is for tests to change.
    shutil.copy(ROOT / 'ws', folder / 'ws')
    shutil.copytree(ROOT / 'test_movement', folder / 'test_movement')
    return folder


def command_in(folder, commands, **variables):
    """Return a command that runs lines of bash which know what ./ws does before a command, as after a login."""
    environment = {'HOME': os.environ['HOME'], 'PATH': os.environ['PATH'],
                   'XDG_CACHE_HOME': str(folder.parents[1]), 'CHECKOUT': str(folder), **variables}
    settings = [f'{name}={value}' for name, value in environment.items()]
    return 'env', '-i', *settings, 'bash', '-c', START + commands


def in_checkout(folder, commands, status=0, **variables):
    """Run these lines to their end; return the Process."""
    return run(*command_in(folder, commands, **variables), status=status, timeout=TIMEOUT)


def set_up(checkout, before=''):
    """Set it up after these lines of bash; return the ended Process."""
    return in_checkout(checkout, f'{FASTER}{before}set_up true')


def make_package(folder, module):
    """Make a package of the folder's name, whose hello.py greets from a module that it imports; return the folder."""
    folder.mkdir(parents=True)
    for name, content in (('package.xml', MANIFEST), ('CMakeLists.txt', CMAKE), ('hello.py', HELLO)):
        (folder / name).write_text(content.format(name=folder.name, module=module))
    (folder / 'hello.py').chmod(0o755)
    return folder
