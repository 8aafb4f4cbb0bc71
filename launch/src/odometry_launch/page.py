"""The browser page beside the demo."""

import signal
import socket
import time

from odometry_launch.launch import DemoError
from odometry_launch.ports import PAGE_PORT, next_port

CHECK_PERIOD = 0.2  # s


class DemoPage:
    """The page's address: the usual port, or the next free one."""

    def __init__(self):
        """Hold the port; raise DemoError if none is free."""
        try:
            self._held = next_port(PAGE_PORT)
        except OSError as error:
            raise DemoError(f'no port is free for the page, from {PAGE_PORT} on: '
                            f'{error.strerror}') from None
        self.port = self._held.number

    def announce(self, launch):
        """Print the address once the page answers there."""
        launch.wait_for(self._answers, 'the page does not answer')
        print(f'view            http://localhost:{self.port}', flush=True)

    def stay(self, launch):
        """Keep the page open until Ctrl-C, which is no failure then."""
        received = []
        signal.signal(signal.SIGTERM, lambda *_: received.append(True))  # it may come twice
        print('The page stays, and its pad drives the robot, until Ctrl-C.', flush=True)
        while not received:
            launch.check()
            time.sleep(CHECK_PERIOD)

    def _answers(self):
        with socket.socket() as connection:
            return connection.connect_ex(('localhost', self.port)) == 0
