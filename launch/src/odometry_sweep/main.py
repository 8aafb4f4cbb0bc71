"""Run a campaign, show its progress, and report the result."""

import os
import signal
import sys

from odometry_common.parameters import StartError
from odometry_launch.folders import RUNS, new_folder
from odometry_launch.graph import DemoError
from odometry_launch.output import complain, forget_output

from odometry_sweep.limits import broken
from odometry_sweep.options import parse
from odometry_sweep.progress import Progress
from odometry_sweep.results import FILE, count_written, written_results
from odometry_sweep.running import LostError, side_by_side
from odometry_sweep.summary import Setting
from odometry_sweep.table import name_of, table

PROGRAM = 'sweep'
EXIT_FAILURE = 1
EXIT_BAD_INPUT = 2
EXIT_INTERRUPTED = 128 + signal.SIGINT


def main():
    """Exit 0 only if every run is done, and within the limits of the campaign."""
    # ./ws passes on by SIGTERM whatever it is ended by.
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        options = parse(sys.argv[1:])
        if options.replay:
            # The nodes' modules take time to import, for which no sweep should wait.
            from odometry_sweep.replay import replay
            replay(*options.replay)
            status = 0
        else:
            options.campaign.check()
            with side_by_side(options.jobs, options.cluster) as run_all:
                status = _sweep(options.campaign, run_all)
    except StartError as error:
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
        status = EXIT_INTERRUPTED
    signal.signal(signal.SIGTERM, signal.SIG_DFL)  # a second one has nothing to say
    forget_output()
    sys.exit(status)


def _sweep(campaign, run_all):
    """Run a campaign by a function of side_by_side(); return the exit status."""
    folder = new_folder(RUNS, 'sweep-')
    rows, total = [], campaign.count
    try:
        with written_results(folder, campaign) as write:
            progress = Progress(total)
            for parameters, figures in run_all(campaign):
                write(parameters, figures)
                rows.append(figures)
                progress.step()
            progress.finish()
    except (KeyboardInterrupt, LostError) as error:
        # Ctrl-C may come when a run is in the file, and not yet among the rows.
        complain(f'{str(error) or "interrupted"} after {count_written(folder)} of {total} runs, '
                 f'which are in {os.path.relpath(folder)}', PROGRAM)
        raise
    return _report(campaign, rows, folder)


def _report(campaign, rows, folder):
    """Print what came out; return the exit status."""
    settings = [Setting(name_of(campaign.varied, parameters),
                        rows[index * campaign.seeds:(index + 1) * campaign.seeds])
                for index, parameters in enumerate(campaign.settings)]
    print(f'\n{table(campaign.tutorial, settings)}\n')
    for setting in settings:
        if setting.not_arrived:
            print(f'not arrived     {setting.not_arrived} of {setting.runs}, with {setting.name}')
    if any(setting.all_equal for setting in settings):
        print('Runs that differ in their seed only are equal where nothing is random: it takes '
              'odometry_source=encoder with a wheel_noise or gyro_noise.')
    print(f'figures         {os.path.relpath(folder / FILE)}\n'
          f'picture         {os.path.relpath(_draw(campaign, settings, folder))}', flush=True)
    lines = [line for setting in settings for line in broken(campaign.limits, setting)]
    for line in lines:
        complain(line, PROGRAM)
    return EXIT_FAILURE if lines else 0


def _draw(campaign, settings, folder):
    """Draw the distributions and return the path of the picture."""
    # matplotlib takes half a second to import, for which no run should wait.
    from odometry_sweep import picture
    path = folder / picture.FILE
    picture.make_figure(campaign.tutorial, settings).savefig(path)
    return path
