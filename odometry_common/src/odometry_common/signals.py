"""Signals that end a node, whatever its main thread waits for."""

import os
import signal
import threading
import time

# s, of the main thread: Python handles a signal that arrives just before a wait after the wait.
LONGEST_WAIT = 0.5
WAKE_UP = signal.SIGURG  # which a process without a handler ignores


def on_signals(handler):
    """Handle Ctrl-C, SIGTERM and a closed terminal, unless nohup has the node outlive that."""
    signal.signal(signal.SIGINT, handler)
    signal.signal(signal.SIGTERM, handler)
    if signal.getsignal(signal.SIGHUP) != signal.SIG_IGN:
        signal.signal(signal.SIGHUP, handler)


def interrupt_waits_by_signals():
    """Have a signal interrupt what the main thread waits for, such as a master without an answer.

    Python handles a signal that arrives just before recv() begins only when that has returned.
    """
    reader, writer = os.pipe()
    os.set_blocking(writer, False)
    signal.set_wakeup_fd(writer)
    signal.signal(WAKE_UP, lambda *_: None)
    threading.Thread(target=_interrupt_main_thread, args=[reader], daemon=True).start()


def _interrupt_main_thread(signals):
    """From the first signal on, interrupt the main thread again and again: this node is ending."""
    os.read(signals, 1)
    while True:
        signal.pthread_kill(threading.main_thread().ident, WAKE_UP)
        time.sleep(LONGEST_WAIT)
