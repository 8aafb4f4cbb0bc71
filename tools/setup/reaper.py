"""Run a command; when it exits, or on Ctrl-C or SIGTERM, end everything that it has started.

usage: python3 -I -S reaper.py COMMAND [ARGUMENT...]

The reaper sends SIGTERM to the command, then to its orphans, then to all descendants at once, and
finally kills them. It reports a process that it cannot kill, such as another user's, and leaves it
running. It exits with the status that a shell shows for the command; after a signal with the
signal's, unless the command exits with 0. Ctrl-Z stops them all. ./ws starts it with the signals
that end it blocked.

It imports little, to start in a few hundredths of a second.
"""

import ctypes
import os
import signal
import sys
import time
from contextlib import suppress

ASK_ALL_AFTER = 4.0  # s; roslaunch ends its nodes one after the other
KILL_AFTER = 9.0  # s
GIVE_UP_AFTER = 20.0  # s; on a busy machine a process may take some to die
ORPHAN_PERIOD = 0.1  # s between two checks; SIGCHLD reports children
STATUS_NO_COMMAND = 127
# A terminal sends the first three to its foreground processes. An ignored one would be inherited.
ENDING = signal.SIGINT, signal.SIGQUIT, signal.SIGHUP, signal.SIGTERM
STANDARD_INPUT, STANDARD_OUTPUT, STANDARD_ERROR = range(3)
# The numbers of prctl() in <linux/prctl.h>
PR_SET_PDEATHSIG, PR_SET_CHILD_SUBREAPER = 1, 36

prctl = ctypes.CDLL(None).prctl


def main(command):
    """Run the command and exit as it exits."""
    signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGCHLD, signal.SIGTSTP, *ENDING])
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)
    ending = set(ENDING)
    if signal.getsignal(signal.SIGHUP) == signal.SIG_IGN:  # by nohup
        ending.remove(signal.SIGHUP)
    # Orphans become children of this process, also those in a session of their own.
    prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
    pid = _start(command)
    statuses, signum = {}, signal.SIGCHLD
    while pid not in statuses and signum == signal.SIGCHLD:
        signum = signal.sigwait({signal.SIGCHLD, signal.SIGTSTP, *ending})
        if signum == signal.SIGTSTP:
            _suspend()
            signum = signal.SIGCHLD
        _reap(statuses)
    _end_all(statuses)
    if signum == signal.SIGCHLD:
        status = statuses[pid]
        os._exit(128 + os.WTERMSIG(status) if os.WIFSIGNALED(status) else os.WEXITSTATUS(status))
    if os.isatty(STANDARD_OUTPUT):
        with suppress(OSError):
            os.write(STANDARD_OUTPUT, b'\n')  # so that the shell's prompt starts a new line
    os._exit(0 if statuses.get(pid) == 0 else 128 + signum)


def _start(command):
    """Start the command, which gets SIGTERM if this process is killed, and return its id."""
    reaper = os.getpid()
    pid = os.fork()
    if pid:
        return pid
    try:
        os.setsid()  # the terminal sends its signals to the reaper only
        for signum in (*ENDING, signal.SIGPIPE, signal.SIGXFSZ):
            signal.signal(signum, signal.SIG_DFL)
        os.dup2(os.open(os.devnull, os.O_RDONLY), STANDARD_INPUT)
        prctl(PR_SET_PDEATHSIG, signal.SIGTERM, 0, 0, 0)
        signal.pthread_sigmask(signal.SIG_SETMASK, [])
        if os.getppid() == reaper:
            os.execvp(command[0], command)
    except OSError as error:
        _complain(f'{command[0]}: {error.strerror}')
    finally:
        os._exit(STATUS_NO_COMMAND)


def _reap(statuses):
    """Record the statuses of children that have ended; return whether any are left."""
    with suppress(ChildProcessError):
        while True:
            pid, status = os.waitpid(-1, os.WNOHANG)
            if not pid:
                return True
            statuses[pid] = status
    return False


def _end_all(statuses):
    """Return once all descendants have ended, except those that cannot be killed."""
    start, asked = time.monotonic(), set()
    while _reap(statuses):
        age = time.monotonic() - start
        pids = _descendants(only_children=age < ASK_ALL_AFTER)
        if age > GIVE_UP_AFTER:
            _complain(f'cannot end {", ".join(map(str, pids))}')
            return
        for pid in pids:
            if age > KILL_AFTER:
                _signal(pid, signal.SIGKILL)
            elif pid not in asked:
                _signal(pid, signal.SIGTERM)
                _signal(pid, signal.SIGCONT)
        asked.update(pids)
        signal.sigtimedwait([signal.SIGCHLD], ORPHAN_PERIOD)


def _suspend():
    """Stop all descendants and this process, as Ctrl-Z should, until the shell continues it."""
    stopped = set()
    while running := set(_descendants(only_children=False)) - stopped:  # some may start others
        for pid in running:
            _signal(pid, signal.SIGSTOP)
        stopped |= running
    os.kill(os.getpid(), signal.SIGSTOP)
    for pid in stopped:
        _signal(pid, signal.SIGCONT)


def _signal(pid, signum):
    with suppress(ProcessLookupError, PermissionError):  # it has ended, or is another user's
        os.kill(pid, signum)


def _descendants(only_children):
    """Return the ids of the children of this process, or of all its descendants."""
    children = {}
    for entry in filter(str.isdigit, os.listdir('/proc')):
        with suppress(OSError), open(f'/proc/{entry}/stat', 'rb') as file:
            parent = int(file.read().rpartition(b')')[2].split()[1])
            children.setdefault(parent, []).append(int(entry))
    found = list(children.get(os.getpid(), []))
    for pid in () if only_children else found:
        found += children.get(pid, [])
    return found


def _complain(line):
    with suppress(OSError):  # the starter may have closed it
        os.write(STANDARD_ERROR, f'{line}\n'.encode())


if __name__ == '__main__':
    main(sys.argv[1:])
