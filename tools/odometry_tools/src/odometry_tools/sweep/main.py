"""Run a campaign, show its progress, and print the result."""

import os
import subprocess
import sys
import time
from datetime import timedelta

from odometry_common.parameters import StartError

from odometry_tools.runs import junit
from odometry_tools.runs.folders import new_folder, path_in_errors
from odometry_tools.runs.output import Line, RunError, bar, complain, run_command
from odometry_tools.sweep.options import parse
from odometry_tools.sweep.results import FILE, NOT_ARRIVED, Combination, table, write_results
from odometry_tools.sweep.running import on_cluster, on_this_machine, run_all
from odometry_tools.sweep.subjects import LAUNCH

SUITE = 'odometry_sweep'
LINE_PERIOD = 5.0  # s


def main():
    """Exit 0 only if every run is done and within the limits of the campaign."""
    run_command(_run, (StartError, ModuleNotFoundError))


def _run():
    """Run the campaign, or replay a run; return the exit status."""
    options = parse(sys.argv[1:])
    if options.replay:
        # The nodes' modules take long to import.
        from odometry_tools.sweep.lockstep import replay
        replay(*options.replay)
        return 0
    campaign = options.campaign.checked()
    if options.junit:
        junit.begin(options.junit)
    with (on_cluster(options.cluster) if options.cluster
          else on_this_machine(campaign, options.jobs)) as backend:
        return _sweep(campaign, run_all(campaign, *backend), options.junit)


def _sweep(campaign, runs, report):
    """Save runs as run_all() yields them, and a report for CI, if any; return the exit status.

    :raises RunError, KeyboardInterrupt: if not all are done
    """
    folder, rows, lost = new_folder('sweep-'), [], None
    try:
        rows.extend(write_results(folder, campaign, with_progress(runs, campaign.count)))
    except (KeyboardInterrupt, RunError) as error:
        lost = error
    begins = range(0, len(rows), campaign.seeds)
    combinations = [
        Combination(name, rows[begin:begin + campaign.seeds])
        for name, begin in zip(campaign.names, begins)]
    if combinations:
        print(f'\n{table(campaign.subject.kind, combinations)}\n', flush=True)
    if lost is None:
        _report(campaign, combinations, folder)
        return int(_exceeds_limits(campaign, combinations, folder, report))
    left = f'after {len(rows)} of {campaign.count} runs, which are in {os.path.relpath(folder)}'
    # Exceptions, so that no other run is waited for.
    if isinstance(lost, RunError):
        raise RunError(f'{lost} {left}')
    complain(f'interrupted {left}')
    raise lost


def with_progress(runs, total):
    """Yield each run but None, and print how many are done and how long the others will take."""
    done = 0
    start = time.monotonic()
    line = Line(LINE_PERIOD, first=LINE_PERIOD)
    for run in runs:
        passed = max(time.monotonic() - start, 1e-3)
        if run is not None:
            done += 1
            yield run
            rate = done / passed
            end = total / rate
        text = f'{bar(done / total)} {done} of {total} runs'
        if done:
            pace = f'{rate:.1f} a second' if rate >= 1 else f'{1 / rate:.1f} s each'
            text += f', {pace}, {timedelta(seconds=max(0, round(end - passed)))} left'
        line.show(text, passed) if done < total else line.finish(text)


def _report(campaign, combinations, folder):
    """Print which runs did not arrive or had no commands, and draw the picture."""
    for number, combination in enumerate(combinations):
        late = combination.values(NOT_ARRIVED)
        if late.any():
            first = late.argmax()
            run = number * campaign.seeds + first + 1
            print(f'not arrived     {late.sum()} of {late.size}, with {combination.name}; '
                  f'the first is run {run}{combination.why(first)}')
    for name, rows in combinations:
        if campaign.subject.kind == LAUNCH and not any(row['commands'] for row in rows):
            print(f'no commands     reached the robot, with {name}: '
                  'see rostopic info /cmd_vel while the nodes run')
    # matplotlib takes half a second to import.
    from odometry_tools.sweep import picture
    path = folder / picture.FILE
    with path_in_errors(path):
        picture.make_figure(campaign.subject, combinations).savefig(path)
    print(f'figures         {os.path.relpath(folder / FILE)}\n'
          f'picture         {os.path.relpath(path)}', flush=True)


def _exceeds_limits(campaign, combinations, folder, report):
    """Print each limit that a Combination exceeds, and replay its worst run.

    :returns: whether there is one
    """
    cases, worst = [], {}  # the numbers of runs, once each, in order
    for limit, most in campaign.limits.items():
        lines, sizes = [], {}  # by number of a combination's worst run
        for index, combination in enumerate(combinations):
            figure, size, run = combination.size_of(limit)
            if not size <= most:
                lines.append(f'{figure} is {size:.6g}, over its limit of {most:g}, '
                             f'with {combination.name}{combination.why(run)}')
                complain(lines[-1])
                sizes[index * campaign.seeds + run + 1] = size
        if sizes:
            worst[max(sizes, key=sizes.get)] = limit
        cases.append(junit.Case(campaign.subject.name, limit, '; '.join(lines), 'limit'))
    if report:
        junit.write(report, SUITE, cases)
    for number in worst:  # in a process of its own, which is a node only once
        subprocess.run([sys.executable, sys.argv[0], '--replay', str(folder), str(number)],
                       check=False)
    if cases and not worst:
        print(f'limits          all {len(cases)} hold', flush=True)
    return bool(worst)
