"""Run a launch file, with its own ROS master or another Launch's, and notice when a node ends."""

import concurrent.futures
import contextlib
import os
import queue
import signal
import threading
import time
import types
import uuid

import rosgraph
import roslaunch.core
import roslaunch.launch
import roslaunch.pmon
import roslib
from roslaunch.launch import ROSLaunchRunner
from roslaunch.pmon import ProcessListener, start_process_monitor

from odometry_tools.runs.launch_files import load, name_of, path_of
from odometry_tools.runs.node_output import NodeOutput
from odometry_tools.runs.output import RunError
from odometry_tools.runs.plain_text import plain
from odometry_tools.runs.ports import next_port, usual_master_port
from odometry_tools.runs.quoting import how_ended

START_TIMEOUT = 180.0  # s; beside 60 busy processes a demo of 0.1 m takes 138 s
ENDING = signal.SIGINT, signal.SIGTERM, signal.SIGHUP
END_TIMEOUT = 5.0  # s; roslaunch then ends a node by SIGTERM, and 2 s later by SIGKILL
CHECK_PERIOD = 0.02  # s
# For roslaunch's monitor, which polls ten times a second. Lockstep waits for a thread in
# time.sleep(), which may poll for work, but not for one that waits for an event.
MONITOR_TIME = types.SimpleNamespace(**{**vars(time), 'sleep': threading.Event().wait})
RUN_ID = str(uuid.uuid1())  # roslaunch compares it with the master's


class Launch(ProcessListener):
    """A context in which the nodes of a launch file run."""

    def __init__(self, package, launch_file, arguments, may_end=(), is_watched=True,
                 beside=None, is_private=False):
        """Start with __enter__().

        :param arguments: dictionary of its arguments
        :param may_end: names of nodes that may exit, with status 0
        :param is_watched: whether the end of any other node is an error
        :param beside: the Launch whose master these nodes use; None: they have their own
        :param is_private: whether that takes a random port, not the one that terminals use
        """
        self._file = (path_of(package, launch_file),
                      [f'{name}:={value}' for name, value in arguments.items()])
        self._may_end, self._is_watched, self._beside = may_end, is_watched, beside
        self._is_private = is_private
        self.names = set()  # of all nodes
        self._ended = {}  # exit codes of nodes by name
        self._is_stopped = False
        self._output = NodeOutput()

    def __enter__(self):
        """Start everything and return at once; OSError: no port is free."""
        if self._beside:
            self.port = self._beside.port
        else:
            self._become_first()
        roslaunch.core.print = lambda *_, **__: None  # it would report each process
        roslaunch.core.clear_printerrlog_handlers()
        roslaunch.core.add_printerrlog_handler(self._output.add)
        roslaunch.launch._TIMEOUT_MASTER_START = START_TIMEOUT
        roslaunch.pmon.time = MONITOR_TIME
        self._monitor = start_process_monitor()
        self._monitor.add_process_listener(self)
        # On a thread: the main thread imports rospy meanwhile.
        self._started = concurrent.futures.ThreadPoolExecutor(1).submit(self._start)
        return self

    def _become_first(self):
        """Reserve a port for the master, and handle signals."""
        usual = usual_master_port()
        self.port = next_port(0 if self._is_private else usual)
        os.environ['ROS_MASTER_URI'] = uri = f'http://localhost:{self.port.number}'
        if not self._is_private and self.port.number != usual:
            print(f'rostopic in another terminal: export ROS_MASTER_URI={uri}', flush=True)
        roslib.set_interactive(True)  # roslaunch sets no signal handlers
        for signum in ENDING:
            signal.signal(signum, self._stop)

    def _start(self):
        config = load(*self._file, self.port.number)
        self.names = {name_of(node) for node in config.nodes}
        self.required = {name_of(node) for node in config.nodes if node.required}
        self.respawning = {name_of(node) for node in config.nodes if node.respawn}
        for node in config.nodes:
            node.required = False  # roslaunch would end the others; check() notices it
        config.nodes_core.clear()  # no rosout: nobody reads its log
        runner = ROSLaunchRunner(RUN_ID, config, pmon=self._monitor, sigint_timeout=END_TIMEOUT)
        with self._output.capture():
            runner.launch()
        self._ended.update({name_of(node): None for node in config.nodes if not node.process_name})

    def __exit__(self, *_):
        """Wait until everything has exited; nodes may write logs until then."""
        concurrent.futures.wait([self._started])
        self.terminate()
        self._monitor.join()
        roslaunch.pmon._pmons.remove(self._monitor)  # else each Launch would stay in memory
        roslaunch.core.clear_printerrlog_handlers()
        self._output.close()
        if not self._beside:
            self.port.close()

    def terminate(self):
        """Start to shut everything down, and return at once."""
        self._monitor.shutdown()

    def _stop(self, *_):
        self._is_stopped = True  # an exception could be swallowed, or printed, by an import

    def process_died(self, process_name, exit_code):
        """Record the exit; roslaunch calls this on its thread."""
        name, _, _ = process_name.partition('-')  # roslaunch numbers all processes but the master
        self._ended[name] = exit_code

    def wait_until_started(self):
        """Return once the parameters are set and the nodes have been started."""
        self.wait_for(self._started.done, 'the nodes have not been started')
        if error := self._started.exception():
            raise RunError(f'the nodes have not been started: {error}')

    def check(self):
        """Raise RunError if a node has exited too early, KeyboardInterrupt after a signal."""
        if self._beside:
            self._beside.check()
        if self._is_stopped:
            raise KeyboardInterrupt
        for name, status in list(self._ended.items()):
            if self._is_watched and (status or name not in self._may_end):
                raise RunError(self.end_of(name))

    def end_of(self, name):
        """Return how a node ended, in one line; after an exception, with the last one printed."""
        status = self._ended[name]
        error = self._output.last_exception() if status == 1 else ''
        said = self._output.complaint_of(name)
        return plain(said or f'{name} has ended {how_ended(status)}{error}')

    def statuses(self):
        """Return the exit codes of nodes that have ended, by name; roslaunch notices it late."""
        for process in list(self._monitor.procs):
            if not process.is_alive():
                self.process_died(process.name, process.exit_code)
        return {**self._ended}

    def pids(self):
        """Return the process ids of the nodes that run, by name; -1 before they are started."""
        pids = {process.name.partition('-')[0]: process.pid
                for process in list(self._monitor.procs)}
        return {name: pids.get(name, -1) for name in self.names - self.statuses().keys()}

    def lines(self):
        """Return what the nodes have printed."""
        return self._output.lines()

    def wait_for(self, condition, complaint):
        """Return once a condition holds; raise RunError if it fails, or after START_TIMEOUT."""
        # SimpleQueue.get() would wait for ever if a signal's handler ended after its timeout.
        end, outcome = time.monotonic() + START_TIMEOUT, queue.Queue()
        # On a thread, since a suspended master or node never answers.
        threading.Thread(target=_wait, args=[condition, outcome], daemon=True).start()
        while time.monotonic() < end:
            try:
                error = outcome.get(timeout=CHECK_PERIOD)
            except queue.Empty:
                self.check()
                continue
            if error:
                raise RunError(f'{complaint}: {type(error).__name__}: {error}') from error
            return
        raise RunError(f'{complaint} within {START_TIMEOUT:g} s; the nodes said last: '
                       f'{self._output.last_lines()}')


def _wait(condition, outcome):
    """Put None into a queue once a condition holds, or its exception."""
    try:
        while True:
            with contextlib.suppress(OSError, rosgraph.MasterException):  # no answer yet
                if condition():
                    break
            time.sleep(CHECK_PERIOD)
        outcome.put(None)
    except Exception as error:  # noqa: BLE001
        outcome.put(error)
