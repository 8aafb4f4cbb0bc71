"""Guarded processes report how they ended, and nothing of them outlives their starter."""

import signal
import socket
import subprocess
import sys

import psutil
import pytest
from odometry_launch.process_guard import REAPER, GuardedProcess
from odometry_tests.linux import marked, new_mark, wait_until_none
from odometry_tests.waiting import PATIENCE, wait_until

STARTER = '''
import sys, time
from odometry_launch.process_guard import GuardedProcess
process = GuardedProcess(*sys.argv[1:])
time.sleep(1000)
'''
HASTY = f'''
import sys
sys.path.insert(0, {str(REAPER.parent)!r})
import reaper
reaper.ASK_ALL_AFTER, reaper.KILL_AFTER, reaper.GIVE_UP_AFTER = 0.2, 0.4, 60.0
'''
# As the kernel answers a signal to another user's process.
POWERLESS = '''
def refuse(*_):
    raise PermissionError
reaper.os.kill, reaper.GIVE_UP_AFTER = refuse, 0.6
'''


@pytest.fixture
def mark(monkeypatch):
    made = new_mark()
    for name, value in made.items():
        monkeypatch.setenv(name, value)
    return made


@pytest.mark.parametrize('command, status, error', [
    (['sh', '-c', 'exit 7'], 7, ''), (['sh', '-c', 'kill -KILL $$'], -signal.SIGKILL, ''),
    (['sh', '-c', 'kill -SEGV $$'], -signal.SIGSEGV, ''),
    (['no-such-command'], 127, 'no-such-command: No such file or directory\n')])
def test_it_ends_as_the_command_ended(command, status, error, capfd):
    assert GuardedProcess(*command).wait() == status
    assert capfd.readouterr().err == error


def test_it_outlasts_a_timeout_for_new_sockets():
    before = socket.getdefaulttimeout()
    socket.setdefaulttimeout(60.0)
    try:
        assert GuardedProcess('sh', '-c', 'sleep 0.1; exit 7').wait() == 7
    finally:
        socket.setdefaulttimeout(before)


@pytest.mark.parametrize('signum', [signal.SIGINT, signal.SIGPIPE, signal.SIGHUP])
def test_signals_reach_the_command(signum):
    """It does not inherit that its starter ignores them."""
    before = signal.signal(signum, signal.SIG_IGN)
    try:
        process = GuardedProcess('sleep', '1000')
        wait_until(lambda: psutil.Process(process.pid).name() == 'sleep', 10.0, 'the command')
        process.send_signal(signum)
        assert process.wait(10.0 * PATIENCE) == -signum
    finally:
        signal.signal(signum, before)


def test_everything_ends_when_the_starter_is_killed(mark):
    with subprocess.Popen([sys.executable, '-c', STARTER, 'bash', '-c',
                           'setsid sleep 1000 & setsid setsid sleep 1001; sleep 1002']) as starter:
        wait_until(lambda: len(marked(mark)) >= 5, 10.0, 'the processes')
        starter.kill()
    wait_until_none(mark)


def test_orphans_end_with_the_command(mark):
    script = 'setsid sleep 1000 & (setsid sleep 1001 &) ; exit 3'
    assert GuardedProcess('bash', '-c', script).wait() == 3
    assert not marked(mark)


def reaper(program, *command, **popen_options):
    """Start a reaper; return its process and our end of its lifeline."""
    ours, theirs = socket.socketpair()
    with theirs:
        return subprocess.Popen([sys.executable, '-c', f'{HASTY}{program}reaper.main(sys.argv[1:])',
                                 *command], stdin=theirs, **popen_options), ours


def test_a_process_that_ignores_sigterm_is_killed(mark):
    process, lifeline = reaper('', 'bash', '-c',
                               'trap : TERM INT; while :; do setsid sleep 1000; done')
    wait_until(lambda: len(marked(mark)) >= 3, 10.0, 'the processes')
    lifeline.close()
    assert process.wait(30.0 * PATIENCE) == -signal.SIGKILL
    assert not marked(mark)


def test_a_process_that_cannot_be_killed_is_named_and_left():
    process, lifeline = reaper(POWERLESS, 'sleep', '1000', stderr=subprocess.PIPE, text=True)
    command = psutil.Process(int(lifeline.recv(64)))
    process.terminate()
    try:
        assert process.wait(30.0 * PATIENCE) == 1
        assert process.communicate()[1] == f'cannot end {command.pid}\n'
    finally:
        command.kill()


def test_the_command_ends_when_its_reaper_is_killed(mark):
    """A robot that it moves would not stop otherwise."""
    process = GuardedProcess('sleep', '1000')
    psutil.Process(process.pid).parent().kill()
    wait_until_none(mark)
