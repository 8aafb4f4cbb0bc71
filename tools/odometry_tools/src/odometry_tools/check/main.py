"""Judge a node, or each of a folder, and report."""

import contextlib
import socket
import sys
import time

from odometry_common.parameters import StartError

from odometry_tools.check.options import command_of, parse
from odometry_tools.check.scenarios import EXERCISES
from odometry_tools.runs.folders import use_writable_logs
from odometry_tools.runs.output import RunError, run_command
from odometry_tools.runs.ports import HOST, next_port

PROGRAM = 'check'
PAGE_PORT = 8080
PAGE_PATIENCE = 60.0  # s of wall time, for a browser


def main():
    """Exit 0 if all passed, 1 if some failed, 2 if the check could not run."""
    run_command(PROGRAM, _run, (StartError, RunError, OSError))


def _run():
    """Judge what the options name; return the exit status."""
    options = parse(sys.argv[1:])
    from odometry_tools.check import report
    if options.is_class:
        from odometry_tools.check.classroom import judge_all
        rows = judge_all(options)
    else:
        verdicts = _judge(options, command_of(options.node))
        rows = report.rows_of(' '.join(options.node), options.exercise, verdicts)
    for path, write in (options.csv, report.write_csv), (options.junit, report.write_junit):
        if path:
            write(path, rows)
    return int(any(row['verdict'] != report.PASSED for row in rows))


def _judge(options, command):
    """Run a node in its scenarios; print and return the Verdicts."""
    from odometry_tools.check import report
    from odometry_tools.check.bench import Bench, Pace
    from odometry_tools.check.judging import PASSED, Judge
    from odometry_tools.check.runner import Runner
    use_writable_logs()
    exercise, verdicts = EXERCISES[options.exercise], []
    print(f'{options.exercise}  {" ".join(options.node)}', flush=True)
    with contextlib.closing(next_port(PAGE_PORT)) as port, Bench(
            exercise, options.view and port.number) as bench:
        if options.view:
            bench.prepare(options.scenarios[0], Pace(True, 1.0))
            _await_spectator(bench, port.number)
        judge = Judge(options.exercise, exercise)
        runner = Runner(bench, exercise, command, float(options.view))
        for number, scenario in enumerate(options.scenarios):
            run = runner.run(scenario)
            verdict = judge.judge(run)
            if verdict.rule != PASSED and not run.pace.lockstep and run.pace.real_time_factor > 1:
                run = runner.run_in_real_time(scenario)
                verdict = judge.judge(run)
            folder = None if verdict.rule == PASSED else report.keep(run, exercise.target)
            report.show(verdict, folder, verdicts)
            verdicts.append(verdict)
            if not run.nodes:  # it would start in no other scenario
                verdicts += [verdict._replace(scenario=other.name)
                             for other in options.scenarios[number + 1:]]
                break
    report.show_notes(verdicts)
    failed = [verdict.scenario for verdict in verdicts if verdict.rule != PASSED]
    example = (f' See one: ./ws check {options.exercise} {" ".join(options.node)} '
               f'--scenario {failed[0]} --view' if failed and run.nodes and not options.view else '')
    print(f'{len(verdicts) - len(failed)} of {len(options.scenarios)} passed.{example}', flush=True)
    return verdicts


def _await_spectator(bench, port):
    """Return once a browser shows the page, or after PAGE_PATIENCE."""
    bench.wait_for(lambda: socket.create_connection((HOST, port)).close() or True,
                   'the page does not answer')
    print(f'open http://{HOST}:{port}: it begins when the page is there', flush=True)
    end = time.monotonic() + PAGE_PATIENCE
    while not bench.has_spectator() and time.monotonic() < end:
        bench.check()
        time.sleep(0.1)
