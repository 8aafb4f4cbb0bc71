"""How users share a clone: who may write it, who only reads it, and sudo."""

import os
import re
import subprocess

import pytest
from checkout import FASTER, RUN_MINE, START, in_checkout, set_up
from odometry_tests.processes import run
from odometry_tests.scripts import ROOT

# Without root's right to write everywhere.
READ_ONLY = 'setpriv --bounding-set=-dac_override ' if os.getuid() == 0 else ''


def as_reader(checkout, commands, **variables):
    """Run them as a user who may not write what is there."""
    script = checkout.parent / 'script.bash'
    script.write_text(START + commands)
    return in_checkout(checkout, f'exec {READ_ONLY}bash "${{CHECKOUT%/*}}/script.bash"', **variables)


@pytest.fixture
def read_only(checkout):
    """Return a function that takes the right to write it from everybody."""
    yield lambda: subprocess.run(['chmod', '-R', 'a-w', checkout], check=True)
    subprocess.run(['chmod', '-R', 'u+w', checkout], check=True)


def test_the_locale_changes_no_fingerprint(checkout):
    """With a sort that answers otherwise in each, for the locales of this system may all sort alike."""
    commands = """
ROOT=. ROS=/usr PYTHON=/ WORKSPACE=$CHECKOUT/.ws VENV=$CHECKOUT/.venv
cd "$CHECKOUT"
sort() { cat; echo "$LC_ALL"; }
build_fingerprint
"""
    found = {in_checkout(checkout, commands, LC_ALL=name).stdout for name in ('C.UTF-8', 'en_US.UTF-8')}
    assert len(found) == 1, found


def test_a_locale_that_is_not_installed_is_no_matter():
    """As over ssh, which brings the locale of another machine."""
    kept = [f'{name}={os.environ[name]}' for name in ('HOME', 'PATH')]
    assert not run('env', '-i', *kept, 'LANG=xx_YY.UTF-8', ROOT / 'ws', 'check', '--help').stderr


def test_who_cannot_write_the_clone_runs_what_is_built(checkout, read_only):
    """Until something is missing: then one line says who is to install it, and how."""
    as_reader(checkout, RUN_MINE)
    (checkout / '.ws/src/mine/new.h').touch()
    read_only()
    ended = as_reader(checkout, RUN_MINE)
    assert './ws: ' not in ended.stderr and 'hello from pybullet' in ended.stdout, ended.output
    ended = as_reader(checkout, FASTER + 'has_requirements() { false; }\nset_up demo --view', status=1)
    assert re.fullmatch(
        r'./ws: not everything that demo needs is installed and built, and you cannot write \S+ '
        r'\(.+\): ask \w+ to type: \S+/ws --set-up demo --view', ended.output.strip()), ended.output


@pytest.mark.skipif(os.getuid() != 0, reason='only root can give files away')
def test_what_sudo_has_left_is_named_with_what_mends_it(checkout):
    set_up(checkout)
    for folder in '.ws', 'runs':
        (checkout / folder).mkdir(exist_ok=True)
        os.chown(checkout / folder, 65534, 65534)
    ended = as_reader(checkout, FASTER + 'set_up demo', status=1)
    assert re.fullmatch(
        r'./ws: these belong to another user, as after sudo: sudo chown -R root: (\S+)/\.ws \1/runs',
        ended.output.strip()), ended.output


@pytest.mark.parametrize('user, owner, shown', [
    ('0', '1000', '-E -H -u #1000 -g #100 -- ./ws demo rotate'), ('0', '0', 'stays'), ('1000', '1000', 'stays')])
def test_under_sudo_it_goes_on_as_the_caller(checkout, user, owner, shown):
    """But not in root's own clone."""
    sudo = checkout.parent / 'sudo'
    sudo.write_text('#!/bin/sh\necho "$@"\n')
    sudo.chmod(0o755)
    ended = in_checkout(checkout, f'id() {{ echo {user}; }}\nstat() {{ echo {owner}; }}\nCHECKOUT=.\n'
                      'leave_root demo rotate\necho stays', SUDO_UID='1000', SUDO_GID='100',
                      PATH=f'{checkout.parent}:{os.environ["PATH"]}')
    assert ended.output.strip() == shown
