"""What ./ws notices of a set-up that was interrupted, damaged or fails."""

import signal

import pytest
from checkout import FASTER, in_checkout, make_checkout

INTERRUPT = FASTER + """
set_up true
catkin_make() { exit 1; }
(build) 2>/dev/null || true
! build_is_ready
"""
PYTHON = """
find_root
VENV=$CHECKOUT/python ROS=/usr PYTHON=/usr/bin/python3
mkdir -p "$VENV/bin"
ln -s /bin/true "$VENV/bin/python3"  # as a pip that has nothing to do
cd "$ROOT"
WORKSPACE=$CHECKOUT
make_python() { true; }
add_requirements requirements.txt test/requirements.txt
has_requirements requirements.txt test/requirements.txt
"""
FAIL = """
fails() { seq 1 100; return 3; }
WORKSPACE=$CHECKOUT/.ws LOG=$CHECKOUT/.ws/setup.log ROS=/usr VENV=$CHECKOUT/.venv
run_step 'an earlier step' echo 'of another step'
run_step 'filling the disk' fails
"""
LOCKED = """
apt_get() {
    [ ! -e "$CHECKOUT/free" ] || { echo updated; return; }
    touch "$CHECKOUT/free"
    echo 'E: Could not get lock /var/lib/apt/lists/lock. It is held by process 1 (apt-get)'
    return 100
}
dpkg() { true; }
apt_update
rm "$CHECKOUT/free"
LOCK_TIMEOUT=0
apt_update
"""
SIGNAL_IT = """
LOG=$CHECKOUT/.ws/setup.log ROS=/usr VENV=$CHECKOUT/.venv
run_step 'a step' true
bash -c "kill -$SIGNAL $$; sleep 0.1"
echo forgotten
"""
PATH = 'find_root; echo "$ROOT"; readlink "$ROOT"'


@pytest.mark.nightly
@pytest.mark.parametrize('commands', [
    INTERRUPT, FASTER + 'set_up true\nrm -r "$WORKSPACE"\n! build_is_ready'])
def test_an_interrupted_or_deleted_build_is_not_taken_for_a_whole_one(checkout, commands):
    run = in_checkout(checkout, commands)
    assert run.stderr == './ws: building the packages ...'


@pytest.mark.parametrize('damage', [
    'rm -r "$VENV"', 'ln -sf /nowhere "$VENV/bin/python3"', 'rm "$VENV"/ready-*',
    'readlink() { echo /usr/bin/python3.99; }'])
def test_it_notices_a_deleted_or_interrupted_python(tmp_path, damage):
    """Or, as in the last of these, another Python of the system."""
    run = in_checkout(make_checkout(tmp_path / 'a/robot', made=()),
                      f'{PYTHON}{damage}\n! has_requirements requirements.txt test/requirements.txt')
    assert not run.output.strip()


def test_the_package_lists_are_updated_once_another_process_has_done_so(checkout):
    run = in_checkout(checkout, LOCKED, status=100)
    assert run.stdout.splitlines()[0] == 'updated' and 'Could not get lock' in run.stdout.splitlines()[1]


def test_a_failed_step_shows_its_last_lines(checkout):
    shown = in_checkout(checkout, FAIL, status=1).stderr.splitlines()
    assert shown[1:3] == ['./ws: filling the disk ...', '81'] and shown[-2] == '100'
    assert shown[-1].endswith('setup.log. The next call tries again.')


@pytest.mark.parametrize('signum', [signal.SIGINT, signal.SIGQUIT])
def test_a_signal_ends_ws_though_its_command_ends_well(checkout, signum):
    assert not in_checkout(checkout, SIGNAL_IT, 128 + signum, SIGNAL=str(int(signum))).stdout


def test_every_home_finds_the_same_link_to_an_odd_path(checkout):
    root, target = in_checkout(checkout, PATH).stdout.splitlines()
    assert target == str(checkout)
    assert in_checkout(checkout, PATH, HOME='/nowhere').stdout.splitlines()[0] == root
    moved = checkout.rename(checkout.with_name("moved 'again'"))
    again, target = in_checkout(moved, f'{PATH}; rm "$ROOT"').stdout.splitlines()
    assert again != root and target == str(moved)
    moved.rename(checkout)
