"""./ws at its later calls: it finds what is gone, and keeps out of the way of others."""

import contextlib
import fcntl
import os

import pytest
from odometry_tests.checkout import FASTER, in_checkout, make_checkout, start_in_checkout
from odometry_tests.processes import Process

COMMANDS = ['demo', 'test', 'bench', 'soak']
RELAY = 'devel/lib/test_movement/test_movement.py'
# Each of them in turn.
TAKE_AWAY = FASTER + """
set_up true
for name in devel devel/setup.bash devel/_setup_util.py devel/.catkin devel/lib/python3 RELAY \\
    src/test_movement src; do
    mv "$WORKSPACE/$name" "$WORKSPACE/away"
    ! build_is_ready || echo "$name is not missed"
    mv "$WORKSPACE/away" "$WORKSPACE/$name"
done
cp -a "$WORKSPACE/RELAY" "$WORKSPACE/away"
: >"$WORKSPACE/RELAY"
! build_is_ready || echo 'the content is not missed'
mv "$WORKSPACE/away" "$WORKSPACE/RELAY"
build_is_ready
""".replace('RELAY', RELAY)
# All that a build makes is there, but it does not get to its end.
INTERRUPT = FASTER + """
set_up true
cp -a "$WORKSPACE" "$CHECKOUT/kept"
catkin_make() {
    cp -a "$CHECKOUT/kept/devel" "$WORKSPACE"
    exit 1
}
(build) || true
! build_is_ready || echo 'nobody has noticed'
rm -r "$WORKSPACE"
mv "$CHECKOUT/kept" "$WORKSPACE"
build_is_ready
"""
MAKE_PYTHON = """
find_root
VENV=$CHECKOUT/python
mkdir -p "$VENV/bin" "$VENV/lib/python3.11/site-packages/matplotlib"
echo >"$VENV/lib/python3.11/site-packages/pybullet.so"
ln -s /bin/true "$VENV/bin/python3"  # as a pip that has nothing to do
add_python "$VENV/ready" "$ROOT/requirements.txt"
python_is_ready
"""


@pytest.fixture
def fresh(tmp_path):
    """Make a checkout in which nothing is set up."""
    return make_checkout(tmp_path / 'fresh', made=())


@pytest.fixture(scope='module')
def other(tmp_path_factory):
    """Make another workspace, with a Python module that no build survives."""
    folder = tmp_path_factory.mktemp('other')
    (folder / '.catkin').write_text(f'{folder}/src')
    (folder / 'catkin_pkg.py').write_text('raise ImportError("of another workspace")')
    return folder


@pytest.fixture(scope='module')
def checkout(tmp_path_factory, other):
    """Set up a checkout while the other workspace is sourced."""
    folder = make_checkout(tmp_path_factory.mktemp('checkout') / 'a' / 'robot')
    sourced = {name: str(other) for name in
               ('CMAKE_PREFIX_PATH', 'PYTHONPATH', 'ROS_PACKAGE_PATH', 'PKG_CONFIG_PATH')}
    run = in_checkout(folder, FASTER + 'set_up true', **sourced)
    assert run.wait() == 0, run.stderr
    return folder


@contextlib.contextmanager
def another_set_up(folder):
    """Do as if another call were at work there."""
    with open(folder / '.ws' / 'lock', 'w') as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


def test_it_does_not_stand_on_another_workspace(checkout, other):
    """Whatever was sourced when it was built."""
    run = in_checkout(checkout, FASTER + 'set_up true\nset +u\n. "$WORKSPACE/devel/setup.bash"\n'
                                         'echo "$CMAKE_PREFIX_PATH $ROS_PACKAGE_PATH"')
    assert run.wait() == 0 and str(checkout) in run.stdout, run.output
    assert str(other) not in run.stdout


def test_nobody_waits_when_nothing_is_missing(checkout):
    """Calls in several terminals do not disturb each other."""
    with another_set_up(checkout):
        run = in_checkout(checkout, FASTER + 'set_up true')
    assert (run.wait(), run.output.strip()) == (0, ''), run.output


@pytest.mark.parametrize('commands', [TAKE_AWAY, INTERRUPT])
def test_it_notices_what_is_gone_or_half_built(checkout, commands):
    """A file of the workspace, its content, a link to a package, the end of a build."""
    run = in_checkout(checkout, commands)
    assert (run.wait(), run.output.strip()) == (0, ''), run.output


@pytest.mark.parametrize('damage', [
    'rm "$VENV/bin/python3"', 'ln -sf /nowhere "$VENV/bin/python3"',
    'rm "$VENV"/lib/*/site-packages/pybullet.so', 'rm -r "$VENV"/lib/*/site-packages/matplotlib',
    'rm "$VENV/made"', 'rm "$VENV/ready"', 'readlink() { echo /usr/bin/python3.99; }'])
def test_it_notices_a_damaged_python(fresh, damage):
    """The last of these: the system has got another Python."""
    run = in_checkout(fresh, f'{MAKE_PYTHON}{damage}\n! python_is_ready')
    assert (run.wait(), run.output.strip()) == (0, ''), run.output


def test_what_is_gone_is_built_anew_once_another_set_up_has_ended(checkout):
    """Two at once would be in each other's way."""
    (checkout / '.ws' / RELAY).unlink()
    with another_set_up(checkout):
        run = start_in_checkout(checkout, FASTER + 'set_up true')
        run.wait_for_output('./ws: another set-up is running; waiting for it')
        assert run.running and 'building' not in run.output
    assert run.wait(60.0) == 0, run.output
    assert run.stderr.endswith('./ws: building the packages ...')
    assert (checkout / '.ws' / RELAY).exists()


def in_fresh(folder, *arguments):
    """Run ./ws there to its end, and return its process; nothing may have come of it."""
    before = set(folder.iterdir())
    environment = {'HOME': str(folder.parent), 'PATH': os.environ['PATH']}
    run = Process('env', '-i', *(f'{name}={value}' for name, value in environment.items()),
                  folder / 'ws', *arguments)
    run.wait()
    assert set(folder.iterdir()) == before
    return run


@pytest.mark.parametrize('arguments', [
    ['--foo'], ['--foo', 'demo'], ['--set-up', '-x', 'demo'], ['--host', '192.0.2.1', '--view']])
def test_an_unknown_option_is_refused_in_one_line(fresh, arguments):
    """At once, instead of after a set-up."""
    run = in_fresh(fresh, *arguments)
    unknown = next(word for word in reversed(arguments) if word.startswith('-'))
    assert run.wait() == 2
    assert run.output.strip() == f'./ws: {unknown} is not one of --host ADDRESS, --set-up, --help'


@pytest.mark.parametrize('command', COMMANDS)
def test_help_installs_nothing(fresh, command):
    """Before anything is set up it says what there is, and how to get more."""
    run = in_fresh(fresh, command, '--help')
    assert run.wait() == 0, run.output
    assert run.stdout.startswith('usage: ./ws [')
    assert run.stdout.splitlines()[-1].endswith(f': ./ws --set-up {command}')
    assert not run.stderr


def test_help_needs_no_extras(checkout):
    """What only the tests themselves need is not installed for their help."""
    run = in_checkout(checkout, FASTER + 'need_for_tests() { echo extras; }\nset_up test --help')
    assert (run.wait(), run.output.strip()) == (0, ''), run.output


def test_pytest_gets_all_that_the_unit_tests_import(checkout):
    """Without the browser and the windows, which they do not need."""
    run = in_checkout(checkout, 'need_python() { echo "$1"; }\nneed_parts() { echo parts; }\n'
                                'find_root\nset_up_extras python3 -m pytest')
    assert run.stdout.split() == ['tests', 'sweep', 'cluster', 'view'], run.output
