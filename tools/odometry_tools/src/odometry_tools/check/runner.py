"""Run one node, unmodified and in a process of its own, in scenarios."""

import tempfile
import time

import rospy
from odometry_common.connections import ask

from odometry_tools.check.check_session import Pace
from odometry_tools.check.endings import WALL_PATIENCE, Drive, Route
from odometry_tools.check.processes import ChildProcess, has_node_logged
from odometry_tools.check.run import Run
from odometry_tools.runs.session import forget

SIGNAL_PERIOD = 0.5  # s of wall time; Python handles signals only between two waits
STANDSTILL = 60.0  # s of wall time without odometry that end a run
POLL_PERIOD = 0.03  # s of wall time, while time stands still
# s of wall time: a registered node is ready when nothing has changed for QUIET, or after BUSY.
QUIET, BUSY = 0.3, 2.0
# A node has failed to register after REGISTRATION_TIMEOUT s of wall time, the last IDLE of them
# without computing, or after REGISTRATION_CPU s of processor time.
REGISTRATION_TIMEOUT, IDLE, REGISTRATION_CPU = 20.0, 2.0, 30.0
# After Ctrl-C time stands still for HOOK_POLLS periods (s of wall time), or until a zero came.
# Then it goes on: a hook may wait for odometry.
HOOK_POLLS, HOOK_PERIOD = 10, 0.1
# How long a node may take to end after Ctrl-C: at least s of wall time, in lockstep or paced,
# and s of simulated time.
INTERRUPT_PATIENCE, PACED_PATIENCE, INTERRUPT_TIME = 6.0, 20.0, 30.0
LEAVE_PATIENCE = 5.0  # s of wall time for an unregistered node to end, and for its last commands
FASTEST, SLOWEST = 5.0, 0.7  # times real time, in the first and in further paced runs
FIRST_PATIENCE = 15.0  # s of wall time for a node to begin; WALL_PATIENCE once it has not


class Runner:
    """Runs a node on a CheckSession, in one scenario after another."""

    def __init__(self, session, program, real_time_factor=0.0):
        """Take the Program of the node, and a real-time factor (0: as fast as possible)."""
        self._session = session
        self._program = program
        self.exercise = session.exercise
        self._factor = real_time_factor
        self.follows_wall = None  # whether two runs in lockstep differ; None: not known
        self.confirmed = set()  # names of rules by which it failed at the slowest pace, too
        self._unawaited = None
        self._is_stubborn = False
        self._patience = FIRST_PATIENCE

    def run(self, scenario, is_slow=False):
        """Return the Run of a Scenario: in lockstep or, if the node cannot be awaited, paced."""
        if not self._unawaited:
            run = self._run(scenario, Pace(True, self._factor))
            if run.unawaited:  # on a busy machine a node may seem busy once
                run = self._run(scenario, Pace(True, self._factor))
            self._unawaited = run.unawaited
        if self._unawaited:
            run = self._run(scenario, Pace(False, SLOWEST if is_slow else self._factor or FASTEST))
            run.unawaited = self._unawaited
        return run

    def run_again(self, scenario, is_slow=True):
        """Return another Run of a Scenario; a paced one at the slowest pace, or as run() does."""
        self._is_stubborn &= not scenario.interrupt
        return self.run(scenario, is_slow)

    def _run(self, scenario, pace):
        self._session.prepare(scenario, pace)
        log = len(self._session.simulator.lines())
        ending = (Route(self._session.drive, self._patience) if self.exercise.route
                  else Drive(self._patience, self.exercise.target))
        self._session.run = run = Run(scenario, pace, ending.is_over)
        with tempfile.TemporaryDirectory() as logs:
            command, environment = self._program
            self._run_node(ChildProcess(command, [*environment, ('ROS_LOG_DIR', logs)]), run, log)
            run.has_begun = has_node_logged(logs)
        if run.first_move is None and not run.moved:
            self._patience = WALL_PATIENCE
        return run

    def _run_node(self, node, run, log):
        """Run a node until its Run is over.

        :param log: number of lines in the simulator's log before the node started
        """
        try:
            self._await_ready(node, run)
            run.is_cpp = node.is_cpp({ask(uri, 'getPid') for uri, _ in run.links} - {None})
            self._session.ask_for_types(run)
            if run.messages or run.nodes and (node.status is None or node.family()):
                self._begin(run, node, log)
            if run.ends and self._session.has_left(run.nodes):
                node.wait(LEAVE_PATIENCE)  # its exit status counts
            self._session.record_graph(run)
            self._session.ask_for_types(run)
            family = node.family()
            run.finish(status=None if family else node.status, output=node.output,
                       has_read_keyboard=node.has_read_keyboard,
                       refuses=self._session.is_refused(run.links, self.exercise.topic))
            # A run in lockstep of a node that cannot be awaited is not judged.
            if run.interrupted is None and not (run.unawaited and run.pace.lockstep):
                self._press_ctrl_c(node, run)
        finally:
            node.end()
            forget(run.nodes)

    def _begin(self, run, node, log):
        """Unpause until the run is over; then press Ctrl-C, if the scenario says so."""
        run.begin = time.monotonic()
        self._session.call('unpause_physics')
        seen, since = 0, run.begin
        with run.changed:
            while not run.over:
                run.changed.wait(SIGNAL_PERIOD)
                run.status = node.status
                self._session.simulator.check()
                self._note_unawaited(run, log)
                if len(run.odometry) > seen:
                    seen, since = len(run.odometry), time.monotonic()
                elif time.monotonic() - since > STANDSTILL:
                    run.finish(unawaited='does not let simulated time go on: '
                                         'give its loop a rospy.sleep()')
        self._session.call('pause_physics')
        self._note_unawaited(run, log)
        if run.scenario.interrupt and not run.unawaited and run.is_driving:
            run.finish(interrupted=len(run.commands), interrupt_time=run.now, over=False)
            self._press_ctrl_c(node, run)
            self._await_last_commands()

    def _note_unawaited(self, run, log):
        for name, reason in self._session.unawaited(log).items():
            if name not in self._session.ours:
                run.finish(unawaited=reason)

    def _await_last_commands(self):
        """Wait until the node's connections are closed, and so all of its commands have arrived."""
        end = time.monotonic() + LEAVE_PATIENCE
        while not self._session.is_silent() and time.monotonic() < end:
            time.sleep(POLL_PERIOD)

    def _press_ctrl_c(self, node, run):
        """Press Ctrl-C; record whether the node and its descendants end."""
        node.interrupt()
        has_ended = (_ends_at_once(node, run)
                     or not self._is_stubborn and self._ends_in_time(node, run.pace))
        if self._is_stubborn and not (has_ended or run.scenario.interrupt):
            return  # an earlier run waited for long
        answers = not has_ended and any(map(self._session.ask, run.nodes))
        run.ends = has_ended or node.status is not None and not answers
        run.leaves_process = run.ends and not has_ended
        self._is_stubborn = not run.ends

    def _ends_in_time(self, node, pace):
        """Return whether the node ends while time goes on: it may sleep before."""
        self._session.call('unpause_physics')
        begin, latest = rospy.get_time(), time.monotonic() + STANDSTILL
        try:
            has_ended = node.wait(INTERRUPT_PATIENCE if pace.lockstep else PACED_PATIENCE)
            while (not has_ended and rospy.get_time() < begin + INTERRUPT_TIME
                   and time.monotonic() < latest):
                has_ended = node.wait(SIGNAL_PERIOD)
            return has_ended
        finally:
            self._session.call('pause_physics')

    def _await_ready(self, node, run):
        """Wait until the node is ready, has ended, or has failed to register."""
        begin = changed = time.monotonic()
        state = registered = None
        while node.status is None or node.family():
            self._session.simulator.check()
            self._session.record_graph(run)
            now, before = time.monotonic(), state
            cpu_time = node.cpu_time()
            state = cpu_time, len(run.nodes), len(run.publishes), len(run.subscribes)
            if state != before:
                changed = now
            if run.nodes and registered is None:
                registered = now
            # Only until there are some: each question has the node compute.
            run.links = run.links or self._session.links(self.exercise.topic)
            is_linked = run.links or self.exercise.topic not in run.publishes
            if registered and (is_linked and now - changed > QUIET or now - registered > BUSY):
                return
            if (now - begin > REGISTRATION_TIMEOUT and now - changed > IDLE
                    or (cpu_time or 0.0) > REGISTRATION_CPU):
                return
            time.sleep(POLL_PERIOD)


def _ends_at_once(node, run):
    """Return whether the node ends while time stands still."""
    for _ in range(HOOK_POLLS):
        has_stopped = bool(run.commands) and not run.commands[-1].moves
        if node.wait(HOOK_PERIOD):
            return True
        if has_stopped:
            break
    return False
