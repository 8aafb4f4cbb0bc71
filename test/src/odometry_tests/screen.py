"""A screen that nobody sees, for programs that draw windows."""

import os
import tempfile
from pathlib import Path
from unittest import mock

import numpy

from odometry_tests.processes import Process
from odometry_tests.waiting import wait_until

WORDS = 25  # of the header of an XWD file, in which Xvfb keeps what is on the screen
NUMBER_OF_COLOURS = 19  # which word of it tells how many colours lie between header and pixels
WORDS_OF_COLOUR = 3


class Screen:
    """A context in which everything that this process starts draws on a virtual screen."""

    def __init__(self, width, height):
        """Take its size in pixels."""
        self._size = width, height

    def __enter__(self):
        """Start an X server."""
        self._folder = tempfile.TemporaryDirectory()
        self._server = Process('Xvfb', '-displayfd', '1', '-screen', '0', '{}x{}x24'.format(
            *self._size), '+extension', 'GLX', '-fbdir', self._folder.name)
        wait_until(lambda: self._server.stdout, 10.0, lambda: self._server.output)
        self._settings = mock.patch.dict(os.environ, DISPLAY=f':{self._server.stdout}',
                                         LIBGL_ALWAYS_SOFTWARE='1')
        self._settings.start()
        return self

    def __exit__(self, *_):
        """End it."""
        self._settings.stop()
        self._server.__exit__()
        self._folder.cleanup()

    def pixels(self):
        """Return what is to be seen: rows, columns, red, green and blue."""
        width, height = self._size
        data = (Path(self._folder.name) / 'Xvfb_screen0').read_bytes()
        header = numpy.frombuffer(data, '>u4', WORDS).astype(int)
        start = header[0] + 4 * WORDS_OF_COLOUR * header[NUMBER_OF_COLOURS]
        rows = numpy.frombuffer(data, numpy.uint8, 4 * width * height, start)
        return rows.reshape(height, width, 4)[:, :, 2::-1]

    def colours(self):
        """Return how many different colours there are."""
        return len(numpy.unique(self.pixels().reshape(-1, 3), axis=0))
