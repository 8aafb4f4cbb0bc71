"""Kept processes end as they are told, and all with whoever has started them."""

import contextlib
import signal
import socket
import subprocess
import sys

import psutil
import pytest
from odometry_launch.keeping import KEEPER, Kept
from odometry_tests.linux import marked, new_mark, wait_until_none
from odometry_tests.waiting import PATIENCE, wait_until

STARTER = '''
import sys, time
from odometry_launch.keeping import Kept
kept = Kept(*sys.argv[1:])
print(kept.pid, flush=True)
time.sleep(1000)
'''
HASTY = '''
import sys
sys.path.insert(0, sys.argv.pop(1))
import keeper
keeper.ASK_ALL_AFTER, keeper.KILL_AFTER, keeper.GIVE_UP_AFTER = 0.2, 0.4, 60.0
'''
RUN = 'keeper.main(sys.argv[1:])'
# As the kernel answers who wants to end another user's process.
POWERLESS = '''
def refuse(*_):
    raise PermissionError
keeper.os.kill, keeper.GIVE_UP_AFTER = refuse, 0.6
'''


@pytest.fixture
def mark(monkeypatch):
    """Mark the processes that a test starts."""
    made = new_mark()
    for name, value in made.items():
        monkeypatch.setenv(name, value)
    return made


@pytest.mark.parametrize('script, status', [
    ('exit 0', 0), ('exit 7', 7), ('kill -KILL $$', -signal.SIGKILL),
    ('kill -INT $$', -signal.SIGINT), ('kill -SEGV $$', -signal.SIGSEGV)])
def test_it_ends_as_the_command_has_ended(script, status):
    """By exit status or by signal."""
    assert Kept('sh', '-c', script).wait() == status


def test_a_command_that_is_not_there_has_the_shell_s_status(capfd):
    """And a line that says so."""
    assert Kept('no-such-command').wait() == 127
    assert capfd.readouterr().err == 'no-such-command: No such file or directory\n'


def test_signals_go_to_the_command_itself():
    """Not to what looks after it."""
    kept = Kept('sleep', '1000')
    command = psutil.Process(kept.pid)
    wait_until(lambda: command.cmdline() == ['sleep', '1000'], 10.0, 'the command')
    kept.send_signal(signal.SIGINT)
    assert kept.wait() == -signal.SIGINT
    kept.send_signal(signal.SIGINT)


@pytest.mark.parametrize('signum', [signal.SIGINT, signal.SIGPIPE, signal.SIGHUP, signal.SIGQUIT])
def test_the_command_does_not_inherit_how_signals_are_treated(signum):
    """Python ignores some, and a shell has its background jobs ignore others."""
    before = signal.signal(signum, signal.SIG_IGN)
    try:
        assert Kept('sh', '-c', f'kill -{int(signum)} $$').wait() == -signum
    finally:
        signal.signal(signum, before)


@pytest.mark.parametrize('signum', [signal.SIGKILL, signal.SIGTERM])
def test_all_end_with_their_starter(mark, signum):
    """Also those that have a session of their own."""
    with subprocess.Popen([sys.executable, '-c', STARTER, 'bash', '-c',
                           'setsid sleep 1000 & setsid setsid sleep 1001; sleep 1002'],
                          stdout=subprocess.PIPE) as starter:
        starter.stdout.readline()
        wait_until(lambda: len(marked(mark)) >= 5, 10.0, 'the processes')
        starter.send_signal(signum)
    wait_until_none(mark)


def test_orphans_end_with_the_command(mark):
    """And its exit status is kept."""
    assert Kept('bash', '-c', 'setsid sleep 1000 & (setsid sleep 1001 &) ; exit 3').wait() == 3
    assert not marked(mark)


def test_what_is_stopped_ends_too(mark):
    """It could not be asked otherwise."""
    kept = Kept('sleep', '1000')
    kept.send_signal(signal.SIGSTOP)
    kept.let_go()
    assert kept.wait(10.0 * PATIENCE) == -signal.SIGTERM
    assert not marked(mark)


def test_what_does_not_want_to_end_is_killed(mark):
    """With all that it goes on starting; here it is given less time for its end than usual."""
    script = 'trap : TERM INT; while :; do setsid sleep 1000; done'
    ours, theirs = socket.socketpair()
    with subprocess.Popen([sys.executable, '-c', HASTY + RUN, KEEPER.parent, 'bash', '-c', script],
                          stdin=theirs) as keeper:
        theirs.close()
        wait_until(lambda: len(marked(mark)) >= 3, 10.0, 'the processes')
        ours.close()
        assert keeper.wait(30.0 * PATIENCE) == -signal.SIGKILL
    assert not marked(mark)


def test_what_cannot_be_killed_is_named_and_left(mark):
    """Instead of being waited for without an end."""
    ours, theirs = socket.socketpair()
    with subprocess.Popen(
            [sys.executable, '-c', HASTY + POWERLESS + RUN, KEEPER.parent, 'sleep', '1000'],
            stdin=theirs, stderr=subprocess.PIPE, text=True) as keeper:
        theirs.close()
        command = psutil.Process(int(ours.recv(64)))
        try:
            wait_until(lambda: command.name() == 'sleep', 10.0, 'the command')
            ours.close()
            assert keeper.wait(30.0 * PATIENCE) == 1
        finally:
            # It ends with its keeper, unless it runs as another user.
            with contextlib.suppress(psutil.NoSuchProcess):
                command.kill()
        assert keeper.stderr.read() == f'cannot end {command.pid} (sleep 1000)\n'


def test_the_command_is_asked_to_end_when_its_keeper_is_killed(mark):
    """A robot that it moves would not stop otherwise."""
    kept = Kept('sleep', '1000')
    assert kept.pid
    kept._popen.kill()
    wait_until_none(mark)
