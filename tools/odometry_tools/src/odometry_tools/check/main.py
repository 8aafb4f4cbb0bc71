"""Judge a node, or each of a folder, and report."""

import contextlib
import os
import socket
import sys
import time

from odometry_common.parameters import StartError

from odometry_tools.check.options import parse, program_of
from odometry_tools.check.scenarios import EXERCISES
from odometry_tools.runs import junit
from odometry_tools.runs.folders import use_writable_logs
from odometry_tools.runs.output import RunError, run_command
from odometry_tools.runs.ports import HOST, next_port

PROGRAM = 'check'
LONGEST_NAME = 100  # characters, in the name of a folder
PAGE_PORT = 8080
PAGE_PATIENCE = 60.0  # s of wall time, for a browser


def main(arguments):
    """Exit 0 if all passed, 1 if some failed, 2 if the check could not run."""
    for stream in sys.stdout, sys.stderr:
        # Names and errors may have letters that this terminal does not know.
        stream.reconfigure(errors='replace')
    run_command(PROGRAM, lambda: _run(arguments), (StartError, RunError, OSError))


def _run(arguments):
    """Judge what the options name; return the exit status."""
    options = parse(arguments)
    from odometry_tools.check import report
    table = report.Table(options.csv or os.devnull)
    rows = []
    if options.junit:
        junit.begin(options.junit)
    for new in _judge_all(options):
        table.add(new)
        rows += new
    if options.junit:
        report.write_junit(options.junit, rows)
    return int(any(row['verdict'] != 'passed' for row in rows))


def _judge_all(options):
    """Yield rows, those of each submission together."""
    if options.is_class:
        from odometry_tools.check.classroom import judge_all
        yield from judge_all(options)
        return
    from odometry_tools.check.report import rows_of
    verdicts = _judge(options, program_of(options.node))
    yield rows_of(' '.join(options.node), options.exercise, verdicts)


def _judge(options, program):
    """Run a node in its scenarios; print and return the Verdicts."""
    from odometry_tools.check import report
    from odometry_tools.check.judging import verdicts_on
    from odometry_tools.check.looking import runs_of
    use_writable_logs()
    exercise, words = EXERCISES[options.exercise], report.plain(' '.join(options.node))
    print(f'{options.exercise}  {words}', flush=True)
    runs = _runs_in_browser(exercise, options.scenarios, program) if options.view else runs_of(
        exercise, options.scenarios, program)
    verdicts, folders = verdicts_on(runs, exercise), {}
    for run, verdict in zip(runs, verdicts):
        if not verdict.has_passed:
            name = '-'.join(['check', options.exercise, *_names(options.node), verdict.scenario])
            folders[verdict.scenario] = report.keep(run, exercise, name)
    # Scenarios are left out only after one in which the node did not begin.
    not_begun = [verdict for run, verdict in zip(runs, verdicts) if not run.odometry]
    by_name = {verdict.scenario: verdict for verdict in verdicts}
    verdicts = [by_name.get(scenario.name) or not_begun[0]._replace(scenario=scenario.name)
                for scenario in options.scenarios]
    report.show(verdicts, {name: folder for name, folder in folders.items() if folder})
    failed = [verdict.scenario for verdict in verdicts if not verdict.has_passed]
    example = (f' See one: ./ws check {options.exercise} {words} --scenario {failed[0]} --view'
               if failed and not not_begun and not options.view else '')
    print(f'{len(verdicts) - len(failed)} of {len(options.scenarios)} passed.{example}', flush=True)
    return verdicts


def _runs_in_browser(exercise, scenarios, program):
    """Return the Runs of a Program, as runs_of() does, one after the other and in a browser."""
    from odometry_tools.check.bench import Bench, Pace
    from odometry_tools.check.looking import look_at_all
    from odometry_tools.check.runner import Runner
    with contextlib.closing(next_port(PAGE_PORT)) as port, Bench(exercise, port.number) as bench:
        bench.prepare(scenarios[0], Pace(True, 1.0))
        _await_spectator(bench, port.number)
        return look_at_all(Runner(bench, program, 1.0), scenarios)


def _names(words):
    # With their folders: in a class several files may have the same name.
    return [word.strip('/')[-LONGEST_NAME:] for word in words if ':=' not in word]


def _await_spectator(bench, port):
    """Return once a browser shows the page, or after PAGE_PATIENCE."""
    bench.simulator.wait_for(lambda: socket.create_connection((HOST, port)).close() or True,
                   'the page does not answer')
    print(f'open http://{HOST}:{port}: it begins when the page is there', flush=True)
    end = time.monotonic() + PAGE_PATIENCE
    while not bench.has_spectator() and time.monotonic() < end:
        bench.simulator.check()
        time.sleep(0.1)
