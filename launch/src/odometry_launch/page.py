"""The browser window beside the demo."""

import socket
import time

from odometry_launch.graph import DemoError

PORT = 8080
URL = f'http://localhost:{PORT}'
CHECK_PERIOD = 0.2  # s


def check_port():
    """Raise DemoError if another program has the page's port."""
    with socket.socket() as probe:
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind(('localhost', PORT))
        except OSError as error:
            raise DemoError(f'the page cannot be at {URL}: {error.strerror}. For another port run '
                            'without --view, and beside it: ./ws rosrun sim_turtlebot view.py '
                            '_port:=8081') from None


def announce(graph):
    """Print where the page is, once it is there."""
    graph.wait_for(_answers, 'the page does not answer')
    print(f'view            {URL}', flush=True)


def stay(graph):
    """Leave the page open until Ctrl-C."""
    try:
        print('The page stays, and its pad drives the robot, until Ctrl-C.', flush=True)
        while True:
            graph.check()
            time.sleep(CHECK_PERIOD)
    except KeyboardInterrupt:
        print()


def _answers():
    with socket.socket() as connection:
        return connection.connect_ex(('localhost', PORT)) == 0
