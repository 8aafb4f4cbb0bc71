"""Run a command; when it or its starter ends, end everything that it has started.

usage: python3 -I -S reaper.py [--in-place] COMMAND [ARGUMENT...]

Standard input is a pipe from the starter. When the starter closes it or dies, or on SIGTERM, the
reaper sends SIGTERM to the command, then to its orphans, then to all descendants at once, and finally
kills them. It reports a process that it cannot kill, such as another user's, and leaves it running. It
exits with the command's exit status, or by the same signal; with 1 if the command is still running.

With --in-place there is no pipe: the reaper takes the place of the command, as for ./ws, and the
first signal that would end the command has the same effect. It exits with the status that a shell
shows for the command; after a signal with the signal's, unless the command exits with 0.

It imports little, to start in a few hundredths of a second.
"""

import ctypes
import os
import signal
import sys
import threading
import time
from contextlib import suppress

ASK_ALL_AFTER = 4.0  # s; roslaunch ends its nodes one after the other
KILL_AFTER = 9.0  # s
GIVE_UP_AFTER = 20.0  # s; on a busy machine a process may take some to die
LOOK_PERIOD = 0.1  # s, for orphans; SIGCHLD reports children
LIFELINE = 0  # standard input
STATUS_LEFT = 1 << 8  # as os.wait() would have it
STATUS_NO_COMMAND = 127
# A terminal sends the first three to its foreground processes. An ignored signal would be inherited.
ENDING = signal.SIGINT, signal.SIGQUIT, signal.SIGHUP, signal.SIGTERM
STANDARD_FILES = range(3)
STANDARD_OUTPUT = 1
# The numbers of prctl() in <linux/prctl.h>
PR_SET_PDEATHSIG, PR_SET_CHILD_SUBREAPER = 1, 36

prctl = ctypes.CDLL(None).prctl


def main(command, in_place=False):
    """Run the command and end as it ends."""
    _open_standard_files()
    signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGCHLD, *ENDING])
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)
    ending = set(ENDING)
    if signal.getsignal(signal.SIGHUP) == signal.SIG_IGN:  # by nohup
        ending.remove(signal.SIGHUP)
    # Orphans become children of this process, also those in a session of their own.
    prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
    pid = _start(command, in_place)
    if not in_place:
        ending = {signal.SIGTERM}
        threading.Thread(target=_watch_starter, daemon=True).start()
    statuses, signum = {}, signal.SIGCHLD
    while pid not in statuses and signum == signal.SIGCHLD:
        signum = signal.sigwait({signal.SIGCHLD, *ending})
        _reap(statuses)
    _end_all(statuses)
    status = statuses.get(pid, STATUS_LEFT)
    if not in_place:
        _end_as(status)
    if signum == signal.SIGCHLD:
        os._exit(128 + os.WTERMSIG(status) if os.WIFSIGNALED(status) else os.WEXITSTATUS(status))
    if os.isatty(STANDARD_OUTPUT):
        with suppress(OSError):
            os.write(STANDARD_OUTPUT, b'\n')  # so that the shell's prompt starts a new line
    os._exit(status and 128 + signum)


def _open_standard_files():
    """Open closed standard files, or another file would get their descriptors."""
    for descriptor in STANDARD_FILES:
        try:
            os.fstat(descriptor)
        except OSError:
            os.set_inheritable(os.open(os.devnull, os.O_RDWR), True)


def _watch_starter():
    """Send this process SIGTERM once the starter has closed the pipe, or died."""
    os.read(LIFELINE, 1)
    os.kill(os.getpid(), signal.SIGTERM)


def _start(command, in_new_session):
    """Start the command, which gets SIGTERM if this process is killed, and return its id."""
    reaper = os.getpid()
    pid = os.fork()
    if pid:
        return pid
    try:
        if in_new_session:
            os.setsid()  # the terminal sends its signals to this process only
        for signum in (*ENDING, signal.SIGPIPE, signal.SIGXFSZ):
            signal.signal(signum, signal.SIG_DFL)
        os.dup2(os.open(os.devnull, os.O_RDONLY), LIFELINE)
        prctl(PR_SET_PDEATHSIG, signal.SIGTERM, 0, 0, 0)
        signal.pthread_sigmask(signal.SIG_SETMASK, [])
        if os.getppid() == reaper:
            os.execvp(command[0], command)
    except OSError as error:
        _complain(f'{command[0]}: {error.strerror}')
    finally:
        os._exit(STATUS_NO_COMMAND)


def _reap(statuses):
    """Note how children have ended; return whether any are left."""
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
        signal.sigtimedwait([signal.SIGCHLD], LOOK_PERIOD)


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
        os.write(2, f'{line}\n'.encode())


def _end_as(status):
    """Exit as a process with this status of os.wait() has exited."""
    if os.WIFSIGNALED(status):
        signum = os.WTERMSIG(status)
        if signum != signal.SIGKILL:
            signal.signal(signum, signal.SIG_DFL)
        signal.pthread_sigmask(signal.SIG_UNBLOCK, [signum])
        os.kill(os.getpid(), signum)
    os._exit(os.WEXITSTATUS(status))  # the other thread may still be reading


if __name__ == '__main__':
    in_place = sys.argv[1:2] == ['--in-place']
    main(sys.argv[1 + in_place:], in_place)
