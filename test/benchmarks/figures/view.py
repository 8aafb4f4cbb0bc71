"""The unpaced graph with a view that no page is open at, beside the graph without."""

from graph import TIMEOUT, UNPACED, Graph
from measuring import SPEED_UNIT, Target, in_turns
from odometry_tests.processes import hold_port, rosrun

NAME, UNIT, TARGET = 'graph unpaced, view without a page', SPEED_UNIT, Target('>=', 0.97)


def measure(options):
    with Graph(*UNPACED) as graph:
        def speed_with_view():
            with hold_port() as port, rosrun('robot_view', 'view.py', f'_port:={port}') as view:
                view.wait_for_output(f'http://localhost:{port}', TIMEOUT)
                return graph.speed(options.window)

        return in_turns(options, speed_with_view, lambda: graph.speed(options.window))
