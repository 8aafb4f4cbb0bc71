#!/usr/bin/env python3
"""Run a tutorial with a simulated TurtleBot 2 and show its progress."""

import logging
import sys
import threading

from odometry_tools.runs.folders import use_writable_logs
from odometry_tools.runs.launch import Launch
from odometry_tools.runs.options import PAGE_PORT, launch_arguments, nodes_that_end, parse
from odometry_tools.runs.output import run_command
from odometry_tools.runs.ports import next_port


def main():
    """Exit 0 only if the robot has finished its task and stopped."""
    options = parse(sys.argv[1:])
    run_command(lambda: _run(options), ())


def _run(options):
    """Run a tutorial; return the exit status."""
    # Do not bother users with logs that cannot be written, or fonts that matplotlib reads.
    logging.raiseExceptions = False
    logging.getLogger('matplotlib').setLevel(logging.ERROR)
    page_port = next_port(PAGE_PORT) if options.view else None
    launch_file, arguments = launch_arguments(options, page_port and page_port.number)
    use_writable_logs()
    with Launch('odometry_launch', launch_file, arguments, nodes_that_end(options)) as launch:
        # While roslaunch starts the nodes, import rospy, and matplotlib on a thread: it may take
        # long to read its fonts.
        from odometry_tools.runs.figure import new_figure
        threading.Thread(target=new_figure, args=[1, 1], daemon=True).start()
        from odometry_tools.runs.following import follow_robot
        return int(not follow_robot(options, launch, page_port))


if __name__ == '__main__':
    main()
