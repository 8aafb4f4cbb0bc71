"""Run scenarios in parallel, and again where chance may have decided."""

import concurrent.futures
import math
import multiprocessing
import os

from odometry_tools.check.check_session import CheckSession
from odometry_tools.check.judging import judge
from odometry_tools.check.runner import SLOWEST, Runner
from odometry_tools.runs.output import Line, RunError, bar

ATTEMPTS = 3
# Each takes long. rospy's handler of Ctrl-C deadlocks once in 250 times, and often if the node
# publishes or logs without a pause: the handler then waits for a lock that the loop holds.
STUBBORN_ATTEMPTS = 2
PROGRESS_PERIOD = 0.1  # s of wall time
done = multiprocessing.Value('i')  # scenarios, in all processes


def runs_of(exercise, scenarios, program):
    """Return the Runs of a Program in Scenarios of an Exercise; fewer if one is conclusive.

    :raises RunError: if the check cannot go on
    """
    jobs = min(len(os.sched_getaffinity(0)), len(scenarios))
    # Neighbours have the same robot parameters, and so share a simulator.
    size = math.ceil(len(scenarios) / jobs)
    parts = [scenarios[begin:begin + size] for begin in range(0, len(scenarios), size)]
    # A forked process has imported everything.
    with concurrent.futures.ProcessPoolExecutor(jobs, multiprocessing.get_context('fork')) as pool:
        try:
            futures = [pool.submit(_run_part, exercise, program, part) for part in parts]
            _show_progress(futures, len(scenarios))
            found = {run.scenario: run for future in futures for run in future.result()}
        except concurrent.futures.BrokenExecutor:
            raise RunError('a process of the check was killed') from None
        except BaseException:
            for process in multiprocessing.active_children():
                process.terminate()
            raise
    return [found[scenario] for scenario in scenarios if scenario in found]


def _run_part(exercise, program, scenarios):
    with CheckSession(exercise) as session:
        return run_all(Runner(session, program), scenarios)


def _show_progress(futures, total):
    """Show progress on a terminal until all are done; raise what ended one."""
    line = Line(math.inf, math.inf)
    while True:
        ended, going = concurrent.futures.wait(futures, PROGRESS_PERIOD)
        for future in ended:
            future.result()
        if not going:
            break
        line.show(f'{bar(done.value / total)} {done.value} of {total} scenarios', 0.0)
    line.show('', 0.0)


def run_all(runner, scenarios):
    """Return a Run of each Scenario, up to one after which the others are known."""
    runs = []
    for scenario in scenarios:
        runs.append(run_until_sure(runner, scenario))
        with done.get_lock():
            done.value += 1
        # A node that has sent something may close its publisher later.
        if runs[0].is_conclusive or not runs[-1].odometry:
            break
    return runs


def run_until_sure(runner, scenario):
    """Return the Run by which to judge a Scenario, repeated if chance may have decided."""
    attempts, run = 1, runner.run(scenario)
    m, _ = judge(run, runner.exercise)
    lacked_zero = m.rule in ('interrupt', 'ceased')
    while (_may_be_luck(m) and m.rule not in runner.confirmed
           and attempts < _most_attempts(m)):
        # Whether a node ends at Ctrl-C is not a matter of pace, and a slow run waits longer.
        is_slow = m.rule != 'interrupt_ignored' or run.pace.real_time_factor == SLOWEST
        again = runner.run_again(scenario, is_slow)
        attempts += 1
        # Where one run ends at Ctrl-C, another that does not is a deadlock in rospy's handler.
        if again.ends or run.interrupted is None or not run.ends:
            run = again
            m, _ = judge(run, runner.exercise)
    run.has_lost_message = attempts > 1 and lacked_zero
    if run.unawaited and not m.passed:
        runner.confirmed.add(m.rule)
    is_complete = run.interrupted is None and not m.is_silent and m.is_finite
    is_sure = m.passed or run.unawaited or attempts > 1 or runner.follows_wall is False
    if is_complete and not is_sure:
        again = runner.run_again(scenario)
        run.follows_wall = not (again.odometry and run.is_like(again))
        # Two drives that the check has ended are alike, even by the wall's clock.
        if not run.is_driving:
            runner.follows_wall = runner.follows_wall or run.follows_wall
    return run


def _most_attempts(m):
    is_rare = m.rule == 'interrupt_ignored' and not m.run.unawaited
    return STUBBORN_ATTEMPTS if is_rare else ATTEMPTS


def _may_be_luck(m):
    """Return whether a right node may fail like this, rarely or on a busy machine.

    A pace may be too fast for it; a message published at exit can be lost; rospy's own handler of
    Ctrl-C can deadlock; a node that ends at once can be missed in the graph.
    """
    if m.passed:
        return False
    return (m.run.unawaited and m.run.pace.real_time_factor > SLOWEST
            or m.rule in ('interrupt', 'interrupt_ignored')
            or m.status == 0 and m.rule in ('ceased', 'no_node'))
