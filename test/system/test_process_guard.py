"""Guarded processes report how they ended, and leave nothing behind.

test_demo_endings kills their starters, and a reaper.
"""

import signal
import subprocess
import sys

import pytest
from odometry_tests.linux import marked
from odometry_tests.process_guard import REAPER, start_guarded
from odometry_tests.processes import command_of
from odometry_tests.waiting import PATIENCE, wait_until

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


@pytest.mark.parametrize('command, status, error', [
    (['sh', '-c', 'exit 7'], 7, ''), (['sh', '-c', 'kill -KILL $$'], 128 + signal.SIGKILL, ''),
    (['no-such-command'], 127, 'no-such-command: No such file or directory\n'),
    (['bash', '-c', 'setsid sleep 1000 & (setsid sleep 1001 &) ; exit 3'], 3, '')])
def test_it_ends_as_the_command_ended_and_with_its_orphans(command, status, error, capfd, mark):
    assert start_guarded(*command).wait() == status
    assert capfd.readouterr().err == error
    assert not marked(mark)


@pytest.mark.parametrize('signum', [signal.SIGINT, signal.SIGPIPE, signal.SIGHUP])
def test_signals_reach_the_command(signum):
    before = signal.signal(signum, signal.SIG_IGN)
    process = start_guarded('sleep', '1000')
    signal.signal(signum, before)
    wait_until(lambda: command_of(process).name() == 'sleep', 10.0, 'the command')
    command = command_of(process)
    process.send_signal(signal.SIGTSTP)  # Ctrl-Z
    # The reaper stops last: only then does a shell continue it.
    wait_until(lambda: command.status() == command.parent().status() == 'stopped', 10.0, 'both to stop')
    process.send_signal(signal.SIGCONT)
    command.send_signal(signum)
    assert process.wait(10.0 * PATIENCE) == 128 + signum


def reaper(program, *command, **popen_options):
    return subprocess.Popen([sys.executable, '-c', f'{HASTY}{program}reaper.main(sys.argv[1:])',
                             *command], **popen_options)


def test_a_process_that_ignores_sigterm_is_killed(mark):
    process = reaper('', 'bash', '-c', 'trap : TERM INT; while :; do setsid sleep 1000; done')
    wait_until(lambda: len(marked(mark)) >= 3, 10.0, 'the processes')
    process.terminate()
    assert process.wait(30.0 * PATIENCE) == 128 + signal.SIGTERM
    assert not marked(mark)


def test_a_process_that_cannot_be_killed_is_named_and_left():
    process = reaper(POWERLESS, 'sleep', '1000', stderr=subprocess.PIPE, text=True)
    command = command_of(process)
    process.terminate()
    try:
        assert process.wait(30.0 * PATIENCE) == 128 + signal.SIGTERM
        assert process.communicate()[1] == f'cannot end {command.pid}\n'
    finally:
        command.kill()
