"""Run a campaign, show its progress, and print the result."""

import os
import signal
import sys
import time
from datetime import timedelta

from odometry_common.parameters import StartError
from odometry_launch.folders import new_folder, path_in_errors
from odometry_launch.output import DemoError, Line, bar, complain, forget_output

from odometry_sweep import limits
from odometry_sweep.limits import PROGRAM
from odometry_sweep.options import parse
from odometry_sweep.results import FILE, Combination, read_rows, table, write_results
from odometry_sweep.running import LostError, side_by_side

EXIT_FAILURE = 1
EXIT_BAD_INPUT = 2
LINE_PERIOD = 5.0  # s


def main():
    """Exit 0 only if every run is done and within the limits of the campaign."""
    # ./ws ends its child by SIGTERM, whatever signal it receives.
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        status = _run(parse(sys.argv[1:]))
    except (StartError, ModuleNotFoundError) as error:
        complain(error, PROGRAM)
        status = EXIT_BAD_INPUT
    except BrokenPipeError:
        status = 128 + signal.SIGPIPE
    except (DemoError, OSError) as error:
        complain(error, PROGRAM)
        status = EXIT_FAILURE
    except LostError:
        status = EXIT_FAILURE
    except KeyboardInterrupt:
        status = 128 + signal.SIGINT
    signal.signal(signal.SIGTERM, signal.SIG_DFL)  # a second one exits without a message
    forget_output()
    sys.exit(status)


def _run(options):
    """Do what the options ask for; return the exit status."""
    if options.replay:
        # The nodes' modules take long to import.
        from odometry_sweep.replay import replay
        replay(*options.replay)
        return 0
    options.campaign.check()
    with side_by_side(options.campaign, options.jobs, options.cluster) as runs:
        return _sweep(options.campaign, runs, options.junit)


def _sweep(campaign, runs, junit):
    """Save the runs of a campaign, as side_by_side() yields them; return the exit status.

    :param junit: path of a file for CI, or None
    """
    folder = new_folder('sweep-')
    total = campaign.count
    rows = []
    try:
        rows.extend(write_results(folder, campaign, with_progress(runs, total)))
    except (KeyboardInterrupt, LostError) as error:
        _print_table(campaign, _combinations(campaign, rows))
        complain(f'{str(error) or "interrupted"} after {len(read_rows(folder))} of {total} runs, '
                 f'which are in {os.path.relpath(folder)}', PROGRAM)
        raise
    combinations = _combinations(campaign, rows)
    _report(campaign, combinations, folder)
    return EXIT_FAILURE if limits.check(campaign, combinations, folder, junit) else 0


def with_progress(runs, total):
    """Yield each run but None, and print how many are done and how long the others will take."""
    done, start, first = 0, time.monotonic(), None
    line = Line(LINE_PERIOD, start + LINE_PERIOD)
    for run in runs:
        now = time.monotonic()
        if run is not None:
            done += 1
            yield run
            first = first or now  # until then, processes start: that says nothing about later runs
        text = f'{bar(done / total)} {done} of {total} runs'
        if done > 1 and now > first:
            speed = (done - 1) / (now - first)
            left = timedelta(seconds=round((total - done) / speed))
            text += f', {speed:.1f} a second, {left} left'
        elif not done:
            text += f' after {timedelta(seconds=round(now - start))}'
        if done < total:
            line.show(text, now)
        else:
            line.finish(text)


def _combinations(campaign, rows):
    """Return the Combinations that the rows cover, in the campaign's order."""
    parts = (rows[begin:begin + campaign.seeds] for begin in range(0, len(rows), campaign.seeds))
    return [Combination(*part) for part in zip(campaign.names, parts)]


def _print_table(campaign, combinations):
    if combinations:
        print(f'\n{table(campaign.tutorial, combinations)}\n', flush=True)


def _report(campaign, combinations, folder):
    """Print statistics, and draw the picture."""
    _print_table(campaign, combinations)
    for combination in combinations:
        if combination.not_arrived:
            print(f'not arrived     {combination.not_arrived} of {len(combination.rows)}, '
                  f'with {combination.name}')
    if any(combination.all_equal for combination in combinations):
        print('Runs with different seeds are equal: for noise, set odometry_source=encoder and '
              'wheel_noise or gyro_noise.')
    # matplotlib takes half a second to import.
    from odometry_sweep import picture
    path = folder / picture.FILE
    with path_in_errors(path):
        picture.make_figure(campaign.tutorial, combinations).savefig(path)
    print(f'figures         {os.path.relpath(folder / FILE)}\n'
          f'picture         {os.path.relpath(path)}', flush=True)
