"""How ./ws makes a workspace: what is the user's stays, the path may be odd, failures say why."""

import signal

import pytest
from odometry_tests.checkout import FASTER, in_checkout, make_checkout
from odometry_tests.own_package import make_package

RUN_MINE = FASTER + """
set_up true
set +u
. "$WORKSPACE/devel/setup.bash"
rosrun mine hello.py
"""
FAIL = """
fails() {
    echo 'E: the disk is full'
    seq 1 100
    return 3
}
LOG=$CHECKOUT/.ws/setup.log
run_step 'an earlier step' echo 'E: of another step'
run_step 'filling the disk' fails
"""
SIGNAL_IT = """
end_by_signals
LOG=$CHECKOUT/.ws/setup.log
run_step 'a step' true
bash -c "kill -$SIGNAL $$; sleep 0.1"
echo forgotten
"""


@pytest.fixture
def checkout(tmp_path):
    """Make a checkout with an odd path and with a package of the user's."""
    folder = make_checkout(tmp_path / "my robots/50 % of $HOME's")
    make_package(folder / '.ws' / 'src' / 'mine', 'pybullet')
    return folder


def test_a_package_of_the_user_is_built_and_survives_a_change_of_ours(checkout):
    """The README has readers clone into .ws/src; a changed package.xml has all built anew."""
    run = in_checkout(checkout, RUN_MINE)
    assert run.stdout == 'hello from pybullet', run.stderr
    manifest = checkout / 'test_movement' / 'package.xml'
    manifest.write_text(manifest.read_text().replace('1.0.0', '1.0.1'))
    run = in_checkout(checkout, RUN_MINE)
    assert 'building the packages' in run.stderr
    assert run.stdout == 'hello from pybullet', run.stderr
    assert 'building' not in in_checkout(checkout, RUN_MINE).stderr


def test_a_failed_step_shows_its_reason(checkout):
    """It may stand long before the end of what the step has printed."""
    run = in_checkout(checkout, FAIL)
    assert run.wait() == 1
    shown = run.stderr.splitlines()
    assert shown[1:3] == ['./ws: filling the disk ...', 'E: the disk is full']
    assert '100' in shown[-2]
    assert len(shown) < 20


@pytest.mark.parametrize('signum, status', [
    (signal.SIGINT, -signal.SIGINT), (signal.SIGQUIT, 128 + signal.SIGQUIT)])
def test_a_signal_is_not_forgotten_that_bash_alone_has_heard(checkout, signum, status):
    """It forgets it when the command that it waits for ends well."""
    run = in_checkout(checkout, SIGNAL_IT, SIGNAL=str(int(signum)))
    assert (run.wait(), run.stdout) == (status, ''), run.stderr


def test_another_home_finds_the_same_workspace(checkout, tmp_path):
    """It would be built anew in the middle of what runs in it; after a move it has to be."""
    show = 'find_root; echo "$ROOT"'
    root = in_checkout(checkout, show).stdout
    assert root.startswith(str(tmp_path))
    assert in_checkout(checkout, show, XDG_CACHE_HOME=str(tmp_path / 'other')).stdout == root
    moved = checkout.rename(checkout.with_name("moved 'again'"))
    again = in_checkout(moved, show)
    assert again.stdout != root and again.wait() == 0, again.stderr


@pytest.mark.parametrize('folder', ['relative', '/with a space', '/proc'])
def test_a_path_of_odd_characters_needs_no_cache(checkout, folder):
    """A home may have a space too, or belong to somebody else."""
    run = in_checkout(checkout, 'find_root; readlink "$ROOT"; echo "$ROOT"; rm "$ROOT"',
                      XDG_CACHE_HOME=folder)
    assert run.wait() == 0, run.stderr
    target, root = run.stdout.splitlines()
    assert target == str(checkout)
    assert root.startswith('/var/tmp/')
