"""What ./ws answers before anything is set up, and where it cannot go on."""

import os
import shlex
import shutil
import subprocess
import tempfile
from pathlib import Path

import pytest
from checkout import in_checkout, make_checkout
from odometry_tests.scripts import ROOT

DEBIAN = """
OPT=/nowhere
has_parts() { [[ $1 == *python3-rospy* ]]; }
run_step() { "${@:2}"; }
as_root() { true; }
"""
NO_SUDO = DEBIAN + """
id() { echo 1000; }
sudo() { return 1; }
has_pybullet() { false; }
set_up demo --view rviz:=true
"""
PACKAGES = DEBIAN + """
dpkg() { [ "$1" != --audit ] && command dpkg "$@"; }
apt-cache() { printf 'python3-rospy:\\n  Installed: (none)\\n  Candidate: %s\\n' "$CANDIDATE"; }
sudo() { true; }
apt_get() { [ "$1" != install ] || echo installs; }
set_up_python() { exit; }
set_up demo
"""
# Python 3.13, for which PyPI has no PyBullet, and its pip, which compiles in a child process.
PYTHON = """#!/bin/bash
case $* in
    *version_info*) echo 3.13 ;;
    *venv*) mkdir -p "$4/bin"; cp "$0" "$4/bin/python3" ;;
    *--wheel-dir*)
        while [ "$1" != --wheel-dir ]; do shift; done
        bash -c "$COMPILER" compiler
        touch "$2/${3/==/-}-cp313-cp313-linux_$(uname -m).whl" ;;
esac
"""
COMPILE = """
find_root
WORKSPACE=$CHECKOUT/.ws LOG=$CHECKOUT/.ws/setup.log VENV=$CHECKOUT/.venv USR=$CHECKOUT/usr
PYTHON=$CHECKOUT/python3 ROS=$USR
mkdir -p "$WORKSPACE"
need_parts() { echo "needs $*"; }
end_by_signals
set_up_python
"""


@pytest.fixture
def fresh(tmp_path):
    return make_checkout(tmp_path / 'fresh' / 'robot', made=())


def in_fresh(folder, *arguments):
    """Run ./ws there to its end, and return its process; it may not make anything."""
    before = set(folder.iterdir())
    run = in_checkout(folder, shlex.join([f'{folder}/ws', *arguments]))
    assert set(folder.iterdir()) == before
    return run


@pytest.mark.parametrize('arguments, answer', [
    (['--foo', 'demo'], '--foo is not one of --host ADDRESS, --set-up, --help'),
    (['--host', '192.0.2.1', '--view'], '--view is not one of --host ADDRESS, --set-up, --help'),
    (['sweep', 'move'], './ws sweep needs the package odometry_sweep, which is not here'),
    (['foo'], 'there is no command foo'),
    (['demoo'], 'there is no command demoo; did you mean ./ws demo?')])
def test_what_makes_no_sense_is_refused_in_one_line(fresh, arguments, answer):
    (fresh / 'odometry_sweep').unlink()
    run = in_fresh(fresh, *arguments)
    assert (run.wait(), run.output.strip()) == (2, f'./ws: {answer}')


@pytest.mark.parametrize('arguments', [
    ['--help'], ['demo', '--help'], ['test', '-h'], ['shell', '--help']])
def test_help_installs_nothing(fresh, arguments):
    run = in_fresh(fresh, *arguments)
    assert run.wait() == 0 and run.stdout.startswith('usage: ./ws '), run.output
    assert not run.stderr
    assert ('--real-time-factor N' in run.stdout) == (arguments[0] == 'demo')


def last_words(folder, commands, **variables):
    """Return the one line with which a set-up ends, without its beginning."""
    run = in_checkout(folder, commands, **variables)
    assert run.wait() == 1, run.output
    assert run.stdout == '' and len(run.stderr.splitlines()) == 1, run.output
    return run.stderr.strip().replace('./ws: ', '', 1)


def test_another_kind_of_system(tmp_path):
    """On macOS there is an older bash and another readlink: nothing else is called there."""
    (tmp_path / 'bash').symlink_to(shutil.which('bash'))
    (tmp_path / 'uname').write_text('#!/bin/sh\necho Darwin\n')
    (tmp_path / 'uname').chmod(0o755)
    run = subprocess.run(['/usr/bin/env', '-i', f'PATH={tmp_path}', ROOT / 'ws', 'demo'],
                         check=False, capture_output=True, text=True)
    assert (run.returncode, run.stdout) == (1, '')
    assert run.stderr == './ws: this needs Linux. On Darwin the container runs: docs/container.md\n'


def test_packages_of_the_system(fresh):
    """Debian 12 has them; Debian 11 has a ROS that fails on its own Python."""
    assert 'installs' in in_checkout(fresh, PACKAGES, CANDIDATE='1.16.0+ds-2').stdout
    assert last_words(fresh, PACKAGES, CANDIDATE='1.15.9+ds1-7+deb11u1') == (
        'ROS 1 is not among the packages of this system, or too old. Here, as anywhere, the '
        'container runs: docs/container.md')


def test_no_sudo(fresh):
    """An administrator needs one command only, with what the typed command asks for besides."""
    start, parts = last_words(fresh, NO_SUDO).split(' --no-install-recommends ')
    assert start == 'this needs root or sudo, or somebody who has it and types: sudo apt-get install'
    assert {'catkin', 'python3-venv', 'rviz', 'python3-dev'} <= set(parts.split())


def test_a_checkout_of_another_user():
    nobody = ['setpriv', '--reuid', '65534', '--clear-groups'] if os.getuid() == 0 else []
    with tempfile.TemporaryDirectory(dir='/var/tmp') as name:
        folder = Path(name)
        shutil.copytree(ROOT / 'setup', folder / 'setup')
        shutil.copy(ROOT / 'ws', folder)
        folder.chmod(0o555)
        run = subprocess.run([*nobody, folder / 'ws', 'demo'], check=False, capture_output=True,
                             text=True, env={'PATH': os.environ['PATH'], 'HOME': '/nowhere'})
        assert (run.returncode, run.stderr) == (1, (
            f'./ws: you cannot write to {folder}, which belongs to {folder.owner()}: clone the '
            'project into a folder of your own\n'))
        folder.chmod(0o755)


def test_pybullet_is_compiled_once(fresh):
    """It says how long it takes; another workspace finds what the first has compiled."""
    (fresh / 'python3').write_text(PYTHON)
    (fresh / 'python3').chmod(0o755)
    first = in_checkout(fresh, COMPILE, COMPILER='true')
    assert (first.wait(), first.stdout) == (0, 'needs python3-dev'), first.output
    assert first.stderr.startswith('./ws: compiling PyBullet, which PyPI lacks for Python 3.13 on ')
    second = in_checkout(fresh, f'{COMPILE}ls "$(wheels)"', COMPILER='false')
    assert (second.wait(), second.stderr) == (0, './ws: installing PyBullet ...'), second.output
    assert second.stdout.startswith('pybullet')
