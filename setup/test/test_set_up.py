"""How ./ws makes a workspace, and what it finds at later calls."""

import contextlib
import fcntl
import shutil
import signal

import pytest
from checkout import (
    FASTER,
    in_checkout,
    make_checkout,
    make_package,
    start_in_checkout,
)

RUN_MINE = FASTER + """
set_up true
set +u
. "$WORKSPACE/devel/setup.bash"
rosrun mine hello.py
echo "$CMAKE_PREFIX_PATH $ROS_PACKAGE_PATH"
"""
INTERRUPT = FASTER + """
set_up true
catkin_make() { exit 1; }
(build) || true
! build_is_ready
"""
PYTHON = """
find_root
VENV=$CHECKOUT/python ROS=/usr PYTHON=/usr/bin/python3
mkdir -p "$VENV/bin"
ln -s /bin/true "$VENV/bin/python3"  # as a pip that has nothing to do
add_python "$VENV/ready" "$ROOT/requirements.txt"
python_is_ready
"""
FAIL = """
fails() { seq 1 100; return 3; }
WORKSPACE=$CHECKOUT/.ws LOG=$CHECKOUT/.ws/setup.log ROS=/usr
run_step 'an earlier step' echo 'of another step'
run_step 'filling the disk' fails
"""
SIGNAL_IT = """
end_by_signals
LOG=$CHECKOUT/.ws/setup.log ROS=/usr
run_step 'a step' true
bash -c "kill -$SIGNAL $$; sleep 0.1"
echo forgotten
"""
PATH = 'find_root; echo "$ROOT"; readlink "$ROOT"'


@pytest.fixture
def checkout(tmp_path):
    """Make a checkout with an odd path and with a package of the user's."""
    folder = make_checkout(tmp_path / "my robots/50 % of $HOME's")
    make_package(folder / '.ws' / 'src' / 'mine', 'pybullet')
    yield folder
    in_checkout(folder, 'find_root; rm "$ROOT"')


@contextlib.contextmanager
def another_set_up(folder):
    """Do as if another call were at work there."""
    with open(folder / '.ws' / 'lock', 'w') as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


@pytest.mark.nightly
def test_a_workspace_is_built_when_something_has_changed(checkout, tmp_path):
    """Packages of the user stay, and nothing comes in from another workspace that is sourced."""
    (tmp_path / 'other').mkdir()
    (tmp_path / 'other' / '.catkin').write_text('/nowhere')
    (tmp_path / 'other' / 'catkin_pkg.py').write_text('raise ImportError("of another workspace")')
    other = {name: f'{tmp_path}/other' for name in
             ('CMAKE_PREFIX_PATH', 'PYTHONPATH', 'ROS_PACKAGE_PATH')}
    run = in_checkout(checkout, RUN_MINE, **other)
    assert run.stdout.startswith('hello from pybullet\n'), run.output
    assert f'{tmp_path}/other' not in run.stdout
    with another_set_up(checkout):  # it need not wait: nothing is missing
        assert in_checkout(checkout, FASTER + 'set_up true').output.strip() == ''
    manifest = checkout / 'test_movement' / 'package.xml'
    manifest.write_text(manifest.read_text().replace('1.0.0', '1.0.1'))
    with another_set_up(checkout):
        run = start_in_checkout(checkout, RUN_MINE)
        run.wait_for_output('./ws: another set-up is running; waiting for it')
        assert run.running and 'building' not in run.output
    assert run.wait(60.0) == 0, run.output
    assert 'building the packages' in run.stderr and 'hello from pybullet' in run.stdout


@pytest.mark.nightly
def test_a_package_that_cannot_be_configured_is_left_out_and_named(checkout):
    """All others run, in this call and in later ones; once it is mended, it is built."""
    broken = checkout / '.ws' / 'src' / 'broken'
    make_package(broken, 'pybullet')
    cmake = broken / 'CMakeLists.txt'
    good = cmake.read_text()
    cmake.write_text(good.replace('catkin REQUIRED', 'catkin REQUIRED COMPONENTS nowhere'))
    for building in ('./ws: building the packages ...\n', ''):
        run = in_checkout(checkout, RUN_MINE)
        assert run.wait() == 0 and run.stdout.startswith('hello from pybullet\n'), run.output
        assert run.stderr.startswith(
            f'{building}./ws: left out broken: Could not find a package configuration file provided '
            'by "nowhere" with any of the following names. '), run.stderr
        assert run.stderr.count('./ws: ') == 1 + bool(building), run.stderr
    cmake.write_text(good)
    run = in_checkout(checkout, RUN_MINE)
    assert 'building the packages' in run.stderr and 'left out' not in run.stderr, run.stderr


@pytest.mark.nightly
@pytest.mark.parametrize('commands', [
    INTERRUPT, FASTER + 'set_up true\nrm -r "$WORKSPACE"\n! build_is_ready'])
def test_an_interrupted_or_deleted_build_is_not_taken_for_a_whole_one(checkout, commands):
    run = in_checkout(checkout, commands)
    assert run.wait() == 0 and run.stderr == './ws: building the packages ...', run.output


@pytest.mark.parametrize('damage', [
    'rm -r "$VENV"', 'ln -sf /nowhere "$VENV/bin/python3"', 'rm "$VENV/ready"',
    'readlink() { echo /usr/bin/python3.99; }'])
def test_it_notices_a_deleted_or_interrupted_python(tmp_path, damage):
    """Or, as in the last of these, another Python of the system."""
    run = in_checkout(make_checkout(tmp_path / 'a' / 'robot', made=()),
                      f'{PYTHON}{damage}\n! python_is_ready')
    assert (run.wait(), run.output.strip()) == (0, ''), run.output


def test_a_failed_step_shows_its_last_lines(checkout):
    run = in_checkout(checkout, FAIL)
    assert run.wait() == 1
    shown = run.stderr.splitlines()
    assert shown[1:3] == ['./ws: filling the disk ...', '81'] and shown[-2] == '100'
    assert shown[-1].endswith('setup.log. The next call tries again.')


@pytest.mark.parametrize('signum, status', [
    (signal.SIGINT, -signal.SIGINT), (signal.SIGQUIT, 128 + signal.SIGQUIT)])
def test_a_signal_ends_ws_though_its_command_ends_well(checkout, signum, status):
    """Bash alone would forget it."""
    run = in_checkout(checkout, SIGNAL_IT, SIGNAL=str(int(signum)))
    assert (run.wait(), run.stdout) == (status, ''), run.stderr


def test_every_home_finds_the_same_link_to_an_odd_path(checkout):
    """The workspace would be built again otherwise; another path has another link."""
    root, target = in_checkout(checkout, PATH).stdout.splitlines()
    assert target == str(checkout)
    assert in_checkout(checkout, PATH, HOME='/nowhere').stdout.splitlines()[0] == root
    moved = shutil.move(str(checkout), f"{checkout.parent}/moved 'again'")
    again, target = in_checkout(checkout.parent / "moved 'again'", f'{PATH}; rm "$ROOT"'
                                ).stdout.splitlines()
    assert again != root and target == moved
    shutil.move(moved, str(checkout))
