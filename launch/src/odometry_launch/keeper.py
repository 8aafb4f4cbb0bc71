"""Run a command, and end all that it has started when the command or its requester has ended.

usage: python3 -I -S keeper.py COMMAND [ARGUMENT...]

Standard input is a socket to the requester. The process id of the command is written to it. When
it is closed at the other end, for whatever reason, or on SIGTERM, everything is asked to end,
from the top: the command first, then what it leaves behind. What has not ended by then is asked
regardless of order, and finally killed. What cannot be killed, such as a process of another user, is
named in a line and left. The exit status is the command's, or 1 if it is left; the same signal ends
this process that has ended the command.

It starts in a few hundredths of a second, since it imports little: no psutil either.
"""

import ctypes
import os
import select
import signal
import sys
import time

ASK_ALL_AFTER = 4.0  # s; roslaunch ends its nodes one after the other
KILL_AFTER = 9.0  # s
GIVE_UP_AFTER = 20.0  # s; on a busy machine a process may take some to die
LOOK_PERIOD = 0.1  # s, for orphans; the end of a child is heard of at once
LIFELINE = 0  # standard input
STATUS_LEFT = 1 << 8  # as os.wait() would have it
# prctl's numbers in <linux/prctl.h>
PR_SET_PDEATHSIG, PR_SET_CHILD_SUBREAPER = 1, 36

prctl = ctypes.CDLL(None).prctl


def main(command):
    """Run the command and end as it ends."""
    told = []
    woken = _wake_on_signals(told)
    # Orphans come to this process, also those that have a session of their own.
    prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
    command_pid = _start(command)
    statuses = {}
    try:
        os.write(LIFELINE, b'%d\n' % command_pid)
        while command_pid not in statuses and not told:
            ready = select.select([LIFELINE, woken], [], [])[0]
            _reap(statuses)
            if woken in ready:
                os.read(woken, 4096)
            if LIFELINE in ready and not os.read(LIFELINE, 1):
                break
    except OSError:
        pass  # the requester is gone
    _end_all(statuses, woken)
    _end_as(statuses.get(command_pid, STATUS_LEFT))


def _wake_on_signals(told):
    """Have signals make a descriptor readable, and return it; SIGTERM is put into `told`.

    Signals of the terminal are not meant for this process. They are handled rather than ignored,
    since the command would inherit that.
    """
    woken, waker = os.pipe()
    os.set_blocking(woken, False)
    os.set_blocking(waker, False)
    signal.set_wakeup_fd(waker, warn_on_full_buffer=False)
    for signum in (signal.SIGINT, signal.SIGHUP, signal.SIGQUIT, signal.SIGCHLD):
        signal.signal(signum, lambda *_: None)
    signal.signal(signal.SIGTERM, lambda signum, _: told.append(signum))
    signal.pthread_sigmask(signal.SIG_SETMASK, [])
    return woken


def _start(command):
    """Start the command, asked to end should this process be killed, and return its id."""
    keeper = os.getpid()
    pid = os.fork()
    if pid:
        return pid
    try:
        # Python ignores the first two, and the command would inherit it. Handled here, the last
        # would be forgotten if it came now.
        for signum in (signal.SIGPIPE, signal.SIGXFSZ, signal.SIGTERM):
            signal.signal(signum, signal.SIG_DFL)
        os.dup2(os.open(os.devnull, os.O_RDONLY), LIFELINE)
        prctl(PR_SET_PDEATHSIG, signal.SIGTERM, 0, 0, 0)
        if os.getppid() == keeper:
            os.execvp(command[0], command)
    except OSError as error:
        os.write(2, f'{command[0]}: {error.strerror}\n'.encode())
    finally:
        os._exit(127)


def _reap(statuses):
    """Note how children have ended; return whether any are left."""
    while True:
        try:
            pid, status = os.waitpid(-1, os.WNOHANG)
        except ChildProcessError:
            return False
        if not pid:
            return True
        statuses[pid] = status


def _end_all(statuses, woken):
    """Return when no descendant is left, or none that can be ended."""
    start, asked = time.monotonic(), set()
    asked_all = False
    while _reap(statuses):
        passed = time.monotonic() - start
        children = _children_by_parent()
        mine = children.get(os.getpid(), [])
        if passed > GIVE_UP_AFTER:
            _name(_with_descendants(mine, children))
            return
        if passed > KILL_AFTER:
            _signal(signal.SIGKILL, _with_descendants(mine, children))
        elif passed > ASK_ALL_AFTER and not asked_all:
            # This includes those that have missed the first time.
            asked_all = True
            _ask(_with_descendants(mine, children), asked)
        else:
            _ask([pid for pid in mine if pid not in asked], asked)
        if select.select([woken], [], [], LOOK_PERIOD)[0]:
            os.read(woken, 4096)


def _name(pids):
    """Print a line that names processes."""
    try:
        os.write(2, f'cannot end {", ".join(map(_description, pids))}\n'.encode())
    except OSError:
        pass  # nobody reads it


def _description(pid):
    """Return the id of a process and, unless it has just ended, its command."""
    try:
        with open(f'/proc/{pid}/cmdline', 'rb') as file:
            return f'{pid} ({file.read().replace(bytes(1), b" ").decode(errors="replace").strip()})'
    except OSError:
        return str(pid)


def _ask(pids, asked):
    """Ask processes to end, also those that are stopped."""
    _signal(signal.SIGTERM, pids)
    _signal(signal.SIGCONT, pids)
    asked.update(pids)


def _signal(signum, pids):
    for pid in pids:
        try:
            os.kill(pid, signum)
        except ProcessLookupError:
            pass
        except PermissionError:
            pass  # it has become another user's


def _children_by_parent():
    """Return the ids of the children of each process, by its id."""
    children = {}
    for entry in os.listdir('/proc'):
        if entry.isdigit():
            try:
                with open(f'/proc/{entry}/stat', 'rb') as file:
                    parent = int(file.read().rpartition(b')')[2].split()[1])
            except OSError:
                continue  # it has ended meanwhile
            children.setdefault(parent, []).append(int(entry))
    return children


def _with_descendants(pids, children):
    """Return the ids of processes and of all their descendants."""
    found = list(pids)
    for pid in found:
        found += children.get(pid, [])
    return found


def _end_as(status):
    """Exit as a process with this status of os.wait() has exited."""
    if os.WIFSIGNALED(status):
        import resource
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        signum = os.WTERMSIG(status)
        if signum != signal.SIGKILL:
            signal.signal(signum, signal.SIG_DFL)
        os.kill(os.getpid(), signum)
    os._exit(os.WEXITSTATUS(status))  # Python's own end takes longer, and there is nothing to end


if __name__ == '__main__':
    main(sys.argv[1:])
