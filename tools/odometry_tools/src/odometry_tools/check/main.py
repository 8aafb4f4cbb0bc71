"""Judge a node, or each submission in a folder, and report."""

import contextlib
import csv
import os
import shlex
import sys
import time

import psutil
from odometry_common.parameters import StartError

from odometry_tools.check.options import parse, program_of
from odometry_tools.check.scenarios import EXERCISES
from odometry_tools.runs import junit
from odometry_tools.runs.folders import use_writable_logs
from odometry_tools.runs.output import RunError, run_command
from odometry_tools.runs.ports import HOST, listens, next_port

LONGEST_NAME = 100  # characters of a word in the name of a folder
PAGE_PORT = 8080
PAGE_PATIENCE = 60.0  # s of wall time until a browser opens the page


def main(arguments):
    """Exit 0 if all passed, 1 if some failed, 2 if the check could not run."""
    for stream in sys.stdout, sys.stderr:
        # The terminal may lack characters that names and errors contain.
        stream.reconfigure(errors='replace')
    run_command(lambda: _run(arguments), (StartError, RunError, OSError))


def _run(arguments):
    """Judge the submissions that the options name; return the exit status."""
    options = parse(arguments)
    from odometry_tools.check import report
    rows = []
    # Rows are written as they come.
    with open(options.csv or os.devnull, 'w', buffering=1, newline='', encoding='utf-8') as file:
        table = csv.DictWriter(file, report.COLUMNS)
        table.writeheader()
        if options.junit:
            junit.begin(options.junit)
        for new in _judge_all(options):
            table.writerows(new)
            rows += new
    if options.junit:
        report.write_junit(options.junit, rows)
    return int(any(row['verdict'] != 'passed' for row in rows))


def _judge_all(options):
    """Yield the rows of each submission."""
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
    from odometry_tools.check.attempts import runs_of
    from odometry_tools.check.judging import verdicts_on
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
    # After a conclusive run the others were skipped.
    conclusive = [verdict for run, verdict in zip(runs, verdicts) if run.is_conclusive]
    by_name = {verdict.scenario: verdict for verdict in verdicts}
    verdicts = [by_name.get(scenario.name) or conclusive[0]._replace(scenario=scenario.name)
                for scenario in options.scenarios]
    report.show(verdicts, {name: folder for name, folder in folders.items() if folder})
    failed = [verdict.scenario for verdict in verdicts if not verdict.has_passed]
    command = report.plain(shlex.join([options.exercise, *options.node]))
    example = (f' See one: ./ws check {command} --scenario {failed[0]} --view'
               if failed and not conclusive and not options.view else '')
    print(f'{len(verdicts) - len(failed)} of {len(options.scenarios)} passed.{example}', flush=True)
    return verdicts


def _runs_in_browser(exercise, scenarios, program):
    """Return the Runs of a Program, one after the other, shown in a browser."""
    from odometry_tools.check.attempts import run_all
    from odometry_tools.check.check_session import CheckSession, Pace
    from odometry_tools.check.runner import Runner
    with contextlib.closing(next_port(PAGE_PORT)) as port, \
            CheckSession(exercise, port.number) as session:
        session.prepare(scenarios[0], Pace(True, 1.0))
        _await_spectator(session, port.number)
        runner = Runner(session, program, 1.0)
        runner.follows_wall = False  # to find that out, it would show a scenario twice
        return run_all(runner, scenarios)


def _names(words):
    # With folders: files of a class may have equal names.
    return [word.strip('/')[-LONGEST_NAME:] for word in words if ':=' not in word]


def _await_spectator(session, port):
    """Return once a browser shows the page, or after PAGE_PATIENCE."""
    session.simulator.wait_for(lambda: listens(port), 'the page does not answer')
    print(f'open http://{HOST}:{port}: it begins when the page is there', flush=True)
    end = time.monotonic() + PAGE_PATIENCE
    while not _is_open(port) and time.monotonic() < end:
        session.simulator.check()
        time.sleep(0.1)


def _is_open(port):
    """Return whether a browser shows the page at a port: it keeps a connection."""
    return any(connection.laddr.port == port and connection.status == psutil.CONN_ESTABLISHED
               for connection in psutil.net_connections('tcp'))
