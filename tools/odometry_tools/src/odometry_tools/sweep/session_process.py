"""A process with a Session, since rospy begins only once in each."""

import contextlib
import io
import multiprocessing
import multiprocessing.util
import os
import select
import signal
import tempfile
import threading
from pathlib import Path

from odometry_tools.runs.folders import use_writable_logs
from odometry_tools.runs.output import RunError
from odometry_tools.sweep.lockstep import run_nodes

CONTEXT = multiprocessing.get_context('forkserver')  # a Dask worker has threads
CONTEXT.set_forkserver_preload([__name__])
kept = threading.local()  # .process: the SessionProcess of the latest run


def run_in_session(subject, parameters):
    """Run a Launched; return the metrics by name.

    The session stays for the next run. If it breaks, a new one repeats the run.

    :raises RunError: if the run cannot be done
    """
    if process := getattr(kept, 'process', None):
        with contextlib.suppress(RunError):
            return process.run(subject, parameters)
        process.close()
    kept.process = SessionProcess()
    return kept.process.run(subject, parameters)


class SessionProcess:
    """A child process with a Session, which does the runs."""

    def __init__(self):
        self._connection, theirs = CONTEXT.Pipe()
        self._process = CONTEXT.Process(target=_serve, args=[theirs])
        self._process.start()
        theirs.close()
        # multiprocessing waits for child processes when this one ends.
        self.close = multiprocessing.util.Finalize(self, self._connection.close, exitpriority=0)

    def run(self, subject, parameters):
        """Do a run, as run_in_session() does."""
        try:
            self._connection.send((subject, parameters))
            result = self._connection.recv()
        except (OSError, EOFError):
            raise RunError('the process that did the run has ended') from None
        if isinstance(result, RunError):
            raise result
        return result


def _serve(connection):
    """Do runs in a Session until the connection is closed or a run fails; leave no files."""
    with tempfile.TemporaryDirectory() as logs, contextlib.redirect_stdout(io.StringIO()), \
            contextlib.redirect_stderr(io.StringIO()), \
            contextlib.suppress(EOFError, ConnectionError, KeyboardInterrupt):
        os.environ['ROS_LOG_DIR'] = logs  # else each run leaves a log
        use_writable_logs(logs)
        try:
            _answer(connection)
        except (RunError, OSError) as error:
            connection.send(RunError(str(error)))


def _answer(connection):
    from odometry_tools.runs.session import Session
    with Session() as session:
        threading.Thread(target=_end_with_sweep, args=[connection], daemon=True).start()
        while True:
            subject, parameters = connection.recv()
            with tempfile.TemporaryDirectory() as folder:
                connection.send(run_nodes(session, subject, parameters, Path(folder))[0])


def _end_with_sweep(connection):
    """Interrupt this process once the other end is closed: a run may take minutes."""
    end = select.poll()
    end.register(connection, select.POLLRDHUP)
    end.poll()
    os.kill(os.getpid(), signal.SIGINT)
