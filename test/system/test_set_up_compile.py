"""./ws where PyBullet has to be compiled: what it says, what it keeps, how it is interrupted."""

import os
import signal
import subprocess

import pytest
from odometry_tests.checkout import START, in_checkout, make_checkout
from odometry_tests.waiting import wait_until

# Python 3.13 and its pip, which compiles by a process of its own.
PYTHON = """#!/bin/bash
case $* in
    *version_info*) echo 3.13 ;;
    *venv*) mkdir -p "$3/bin"; cp "$0" "$3/bin/python3" ;;
    *--wheel-dir*)
        while [ "$1" != --wheel-dir ]; do shift; done
        bash -c "$COMPILER" compiler
        mkdir -p "$2"
        touch "$2/${3/==/-}-cp313-cp313-linux_$(uname -m).whl" ;;
esac
"""
NEED = """
find_root
WORKSPACE=$CHECKOUT/.ws LOG=$CHECKOUT/.ws/setup.log USR=$CHECKOUT/usr PYTHON=$CHECKOUT/python3
ROS=$USR
mkdir -p "$WORKSPACE"
need_parts() { echo "needs $*"; }
end_by_signals
need_pybullet
ls "$WHEELS"
"""
WAITS = 'trap "touch $CHECKOUT/ended; exit" TERM; touch $CHECKOUT/begun; sleep 1000 & wait'


@pytest.fixture
def make(tmp_path):
    """Return a function that makes a checkout of a name."""
    def make_it(name):
        folder = make_checkout(tmp_path / 'home' / name, made=())
        (folder / 'python3').write_text(PYTHON)
        (folder / 'python3').chmod(0o755)
        return folder
    return make_it


def test_it_is_announced_and_done_once(make):
    """A second workspace, of another path, finds what the first has kept."""
    first = in_checkout(make('first'), NEED, COMPILER='true')
    assert first.wait() == 0, first.output
    needs, wheel = first.stdout.splitlines()
    assert (needs, wheel[:8]) == ('needs python3-dev', 'pybullet')
    announced, step = first.stderr.splitlines()
    assert announced.startswith('./ws: PyPI has no PyBullet for Python 3.13 on ')
    assert 'minutes' in announced and step == './ws: compiling PyBullet ...'
    second = in_checkout(make('second'), NEED, COMPILER='false')
    assert (second.wait(), second.stdout, second.stderr) == (0, wheel, '')


def test_an_interruption_ends_the_compilers(make):
    """Nothing goes on in the background, and the next call begins anew."""
    folder = make('robot')
    # Not as a Process, which would end what is left of it.
    variables = {'CHECKOUT': str(folder), 'COMPILER': WAITS, 'XDG_CACHE_HOME': str(folder)}
    with subprocess.Popen(['bash', '-c', START + NEED], env={**os.environ, **variables}) as run:
        wait_until((folder / 'begun').exists, 20.0, 'the compiler')
        run.send_signal(signal.SIGTERM)
    assert run.returncode != 0
    wait_until((folder / 'ended').exists, 20.0, "the compiler's end")
    again = in_checkout(folder, NEED, COMPILER='true')
    assert again.wait() == 0 and 'compiling' in again.stderr, again.output
