"""PyBullet's window: check for a display, and notice when the window is closed."""

import contextlib
import ctypes
import threading

LIBRARIES = ['libX11.so.6', 'libGL.so.1']  # without them PyBullet ends the process


class NoScreenError(RuntimeError):
    """There is no display for a window; the message says what is missing."""


class Window:
    """Notices when the window is closed.

    Its window manager cuts PyBullet's connection to the X server then, and Xlib would end the
    whole process with status 1. Instead the thread that drew the window is put to sleep.
    """

    def __init__(self):
        """Ask Xlib to report lost connections and windows to us."""
        self.closed = False
        self._handler = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p)(
            self._on_error)
        x11 = ctypes.CDLL('libX11.so.6')
        x11.XSetIOErrorHandler(self._handler)
        x11.XSetErrorHandler(self._handler)

    def _on_error(self, _display, _error):
        self.closed = True
        threading.Event().wait()


@contextlib.contextmanager
def screen():
    """Hold a connection to the screen.

    Without a screen PyBullet would end the whole process. And an X server restarts when its last
    client has left, and refuses connections at that moment.

    :raises NoScreenError: if there is none, or no library to draw on it with
    """
    for library in LIBRARIES:
        try:
            ctypes.CDLL(library)
        except OSError:
            raise NoScreenError(f'{library} is not installed') from None
    x11 = ctypes.CDLL('libX11.so.6')
    x11.XOpenDisplay.restype = ctypes.c_void_p
    display = x11.XOpenDisplay(None)
    if not display:
        raise NoScreenError('no display; set DISPLAY')
    try:
        yield
    finally:
        x11.XCloseDisplay(ctypes.c_void_p(display))
