"""A screen that nobody sees, for programs that draw windows."""

import os
from unittest import mock

import numpy
from PIL import ImageGrab

from odometry_tests.processes import Process
from odometry_tests.waiting import wait_until


class Screen:
    """A context in which everything that this process starts draws on a virtual screen."""

    def __init__(self, width, height):
        self._size = width, height

    def __enter__(self):
        """Start an X server."""
        self._server = Process('Xvfb', '-displayfd', '1', '-screen', '0', '{}x{}x24'.format(
            *self._size), '+extension', 'GLX', '-noreset')
        wait_until(lambda: self._server.stdout, 10.0, lambda: self._server.output)
        self._settings = mock.patch.dict(os.environ, DISPLAY=f':{self._server.stdout}',
                                         LIBGL_ALWAYS_SOFTWARE='1')
        self._settings.start()
        return self

    def __exit__(self, *_):
        self._settings.stop()
        self._server.__exit__()

    def pixels(self):
        """Return what is to be seen: rows, columns, red, green and blue."""
        return numpy.asarray(ImageGrab.grab(xdisplay=os.environ['DISPLAY']))

    def colours(self):
        return len(numpy.unique(self.pixels().reshape(-1, 3), axis=0))
