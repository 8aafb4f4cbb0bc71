"""What looks like a checkout of this project, for ./ws to set up."""

import os
import shutil

from odometry_tests.processes import Process
from odometry_tests.scripts import ROOT

TIMEOUT = 60.0  # s
START = """
set -euo pipefail
CALLED_FROM=/
. "$CHECKOUT/setup/set_up.bash"
"""
# The set-up of a few packages, with the virtual environment of this project.
FASTER = """
python_is_ready() { true; }
PACKAGES=(odometry_common test_movement)
"""


def make_checkout(folder, made=('.venv',)):
    """Make it of links to this project's files, and to that of what ./ws makes which is named."""
    folder.mkdir(parents=True)
    for path in ROOT.iterdir():
        if path.name in made or path.name not in ('.venv', '.ws', 'ws', 'test_movement'):
            (folder / path.name).symlink_to(path)
    # A link would lead ./ws elsewhere, and this package is for tests to change.
    shutil.copy(ROOT / 'ws', folder / 'ws')
    shutil.copytree(ROOT / 'test_movement', folder / 'test_movement')
    return folder


def start_in_checkout(folder, commands, **variables):
    """Start lines of bash that know what ./ws does before a command, in a login's environment."""
    environment = {'HOME': os.environ['HOME'], 'PATH': os.environ['PATH'],
                   'XDG_CACHE_HOME': str(folder.parents[1]), 'CHECKOUT': str(folder), **variables}
    settings = [f'{name}={value}' for name, value in environment.items()]
    return Process('env', '-i', *settings, 'bash', '-c', START + commands)


def in_checkout(folder, commands, **variables):
    """Run such lines to their end, and return their process."""
    run = start_in_checkout(folder, commands, **variables)
    run.wait(TIMEOUT)
    return run
