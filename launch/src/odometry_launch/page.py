"""The browser window beside the demo."""

import signal
import socket
import time

from odometry_launch.graph import DemoError
from odometry_launch.ports import PAGE_PORT, page_port

CHECK_PERIOD = 0.2  # s


class Page:
    """The page's address: the usual port, or the next one that is free."""

    def __init__(self):
        """Hold the port; raise DemoError if there is none."""
        try:
            self._held = page_port(PAGE_PORT)
        except OSError as error:
            raise DemoError(f'no port is free for the page, from {PAGE_PORT} on: '
                            f'{error.strerror}') from None
        self.port = self._held.number
        self.url = f'http://localhost:{self.port}'

    def announce(self, graph):
        """Print where the page is, once it is there."""
        graph.wait_for(self._answers, 'the page does not answer')
        print(f'view            {self.url}', flush=True)

    def stay(self, graph):
        """Leave the page open until Ctrl-C, which is not a failure then."""
        ended = []
        signal.signal(signal.SIGTERM, lambda *_: ended.append(True))
        print('The page stays, and its pad drives the robot, until Ctrl-C.', flush=True)
        while not ended:
            graph.check()
            time.sleep(CHECK_PERIOD)
        # SIGTERM may come more than once, which must not spoil the exit status.
        signal.signal(signal.SIGTERM, signal.SIG_IGN)

    def _answers(self):
        with socket.socket() as connection:
            return connection.connect_ex(('localhost', self.port)) == 0
