"""PyBullet's window: whether there is a screen for it, and whether somebody has closed it."""

import ctypes
import threading


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


def has_screen():
    """Ask X itself: without a screen PyBullet would end the whole process."""
    try:
        x11 = ctypes.CDLL('libX11.so.6')
    except OSError:
        return False
    x11.XOpenDisplay.restype = ctypes.c_void_p
    display = x11.XOpenDisplay(None)
    if display:
        x11.XCloseDisplay(ctypes.c_void_p(display))
    return bool(display)
