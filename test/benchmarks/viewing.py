"""What the browser view costs the simulation."""

import contextlib
import importlib.util

from graph import Graph
from measuring import Target, compare, in_turns
from odometry_tests.processes import hold_port, rosrun
from speed import SPEED_UNIT, UNPACED

TIMEOUT = 30.0  # s


def viewing(options):
    """Measure the unpaced graph with the viewer, nobody looking and somebody looking."""
    if importlib.util.find_spec('viser') is None:
        print('view: left out, for viser is not installed; ./ws bench installs it')
        return
    with Graph(*UNPACED) as graph:
        def speed(viewer):
            with viewer():
                sample = graph.watch(options.window)
            return sample.simulated / sample.wall

        yield _compare('view without a page', speed, _viewer, options, Target('>=', 0.97))
        if importlib.util.find_spec('selenium') is None:
            print('view with a page: left out, for there is no browser; ./ws bench view installs it')
            return
        yield _compare('view with a page', speed, _watched_viewer, options)


def _compare(name, speed, viewer, options, target=None):
    pairs = in_turns(options.runs, lambda: speed(viewer),
                     lambda: speed(contextlib.nullcontext))
    return compare(f'graph unpaced, {name}', SPEED_UNIT, pairs, target)


@contextlib.contextmanager
def _viewer():
    """Run the viewer, and yield the address of its page."""
    with hold_port() as port, \
            rosrun('robot_view', 'view.py', f'_port:={port}') as viewer:
        viewer.wait_for_output(f'http://localhost:{port}', TIMEOUT)
        yield f'http://localhost:{port}'


@contextlib.contextmanager
def _watched_viewer():
    """Run the viewer and look at it with a browser."""
    from odometry_tests.browser import Browser  # needs selenium
    with _viewer() as address, Browser() as browser, browser.open(address):
        yield
