"""Drive a simulated robot at random for a day of its time, and check every step.

The simulator runs in lockstep with this program, which commands the robot, resets it, pauses it
and restarts the detector as a seed says. At the first thing that is not as it must be, it says
what, at which step, and how to repeat the run, and exits 1.
"""

import argparse
import itertools
import os
import signal
import sys
import time
from datetime import timedelta

from course import PERIOD, course
from driver import Driver
from nodes import Nodes

STEPS_PER_HOUR = round(3600 / PERIOD)
EXIT_VIOLATION = 1
EXIT_INTERRUPTED = 130


def main():
    options = _parse()
    _on_signals(signal.default_int_handler)
    try:
        with Nodes() as nodes:
            status = _drive(nodes, options)
    except AssertionError as error:
        print(f'soak: the nodes do not start: {error}', file=sys.stderr)
        status = EXIT_VIOLATION
    except KeyboardInterrupt:
        print('soak: interrupted', file=sys.stderr)
        status = EXIT_INTERRUPTED
    sys.exit(status)


def _drive(nodes, options):
    start = time.monotonic()
    steps = round(options.hours * STEPS_PER_HOUR)
    driver, violation = Driver(nodes, steps), None
    # An exception in the middle of a step could be lost: rospy catches all of them in places.
    signals = []
    _on_signals(lambda signum, _frame: signals.append(signum))
    try:
        print(f'soak: seed {options.seed}, {options.hours:g} simulated hours, '
              f'ROS_MASTER_URI={os.environ["ROS_MASTER_URI"]}', flush=True)
        for moment in itertools.islice(course(options.seed), steps):
            if signals:
                raise KeyboardInterrupt
            driver.step(*moment)
            if driver.steps % STEPS_PER_HOUR == 0:
                print(f'{_clock(driver.seconds)} simulated, {driver.metres:.0f} m', flush=True)
    except AssertionError as found:
        violation = found
    finally:
        # The nodes end within seconds, which a second Ctrl-C must not cut short.
        _on_signals(signal.SIG_IGN)
        print(_summary(driver, violation, time.monotonic() - start), flush=True)
    if violation is None:
        return 0
    print(f'replay: ./ws soak --seed {options.seed} --hours {options.hours:g}')
    return EXIT_VIOLATION


def _summary(driver, violation, wall):
    """Return the whole result; `violation`: None or the one that ended it, `wall`: seconds."""
    rows = [('simulated time', _clock(driver.seconds)), ('driven', f'{driver.metres:.1f} m'),
            ('steps checked', driver.steps), *driver.events.items(),
            *((f'usage of {name}', f'{measured[0]} -> {measured[-1]}')
              for name, measured in driver.usage.items()),
            ('wall time', _clock(wall)), ('violations', 0 if violation is None else 1)]
    lines = [f'{name + ":":28}{value}' for name, value in rows]
    if violation is not None:
        lines.append(f'violation at step {driver.steps + 1}: {violation}')
    return '\n'.join(lines)


def _clock(seconds):
    return str(timedelta(seconds=round(seconds)))


def _on_signals(handler):
    """Handle Ctrl-C, SIGTERM and, unless nohup has it ignored, a closed terminal."""
    for signum in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        if signum != signal.SIGHUP or signal.getsignal(signum) != signal.SIG_IGN:
            signal.signal(signum, handler)


def _parse():
    parser = argparse.ArgumentParser(prog='./ws soak', description=__doc__)
    parser.add_argument('--hours', type=_positive, default=24.0,
                        help='simulated hours, also a fraction (default: 24)')
    parser.add_argument('--seed', type=int, default=0,
                        help='another seed drives another course (default: 0)')
    return parser.parse_args()


def _positive(text):
    value = float(text)
    if not 0 < value < float('inf'):
        raise argparse.ArgumentTypeError(f'{text} is not a number of hours above 0')
    return value


if __name__ == '__main__':
    main()
