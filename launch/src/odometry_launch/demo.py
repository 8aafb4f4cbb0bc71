"""Run a tutorial with a simulated robot, show its progress, and report the result.

Its parent ends it by SIGTERM, which Python obeys at any moment without a message; the nodes end
with it.
"""

import logging
import signal
import sys
from concurrent.futures import ThreadPoolExecutor
from importlib import import_module

from odometry_launch.graph import DemoError, Graph
from odometry_launch.logs import place_for_logs
from odometry_launch.options import launch_arguments, nodes_that_end, parse
from odometry_launch.output import complain, forget_output
from odometry_launch.page import Page


def main():
    """Exit 0 only if the robot did what it was told and stands."""
    options = parse(sys.argv[1:])
    try:
        status = 0 if _run(options) else 1
        sys.stdout.flush()
    except BrokenPipeError:
        status = 128 + signal.SIGPIPE
    except (DemoError, OSError) as error:
        status = 1
        complain(error)
    forget_output()
    sys.exit(status)


def _run(options):
    # The user need not know that rospy cannot write to its log, or that matplotlib reads fonts.
    logging.raiseExceptions = False
    logging.getLogger('matplotlib').setLevel(logging.ERROR)
    page = Page() if options.view else None
    launch_file, arguments = launch_arguments(options, page.port if page else None)
    with place_for_logs(), Graph(launch_file, arguments, nodes_that_end(options)) as graph:
        if graph.unusual_address:
            print('rostopic in another terminal: '
                  f'export ROS_MASTER_URI={graph.unusual_address}', flush=True)
        # roslaunch reads its files while this imports rospy and matplotlib. That may take long to
        # read its fonts, and the robot does not wait for it.
        picture = ThreadPoolExecutor(1).submit(import_module, 'odometry_launch.picture')
        from odometry_launch.following import follow
        complaint = follow(options, graph, page, picture)
        if page and sys.stdout.isatty():
            page.stay(graph)
    return not complaint
