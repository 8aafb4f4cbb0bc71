"""A virtual screen for programs that draw windows."""

import contextlib
import os
from unittest import mock

from odometry_tests.processes import Process
from odometry_tests.waiting import wait_until
from PIL import ImageGrab


@contextlib.contextmanager
def virtual_screen():
    with Process('Xvfb', '-displayfd', '1', '-screen', '0', '800x600x24', '+extension', 'GLX',
                 '-noreset') as server:
        wait_until(lambda: server.stdout, 10.0, lambda: server.output)
        with mock.patch.dict(os.environ, DISPLAY=f':{server.stdout}', LIBGL_ALWAYS_SOFTWARE='1'):
            yield


def colours():
    return len(ImageGrab.grab(xdisplay=os.environ['DISPLAY']).getcolors(2**24))
