"""A terminal into which a test types what a reader types."""

import fcntl
import os
import pty
import re
import select
import struct
import subprocess
import termios

from odometry_tests.forms import plain_lines
from odometry_tests.waiting import PATIENCE, TIMEOUT, wait_until

MARK = '\x1e'
# Before each prompt the shell prints the exit status of the last command.
PROMPT_COMMAND = r"printf '\036%d\036' $?"
PROMPT = re.compile(f'{MARK}(\\d+){MARK}')
SIZE = struct.pack('HHHH', 50, 1000, 0, 0)  # rows and columns: no line is wrapped
CTRL_C = b'\x03'
LATEST = 40  # lines
LOOKING_PERIOD = 0.05  # s


class Terminal:
    """An interactive bash in a folder."""

    def __init__(self, folder, env):
        """Start it with this environment and nothing else; return once it shows a prompt."""
        self._screen, keyboard = pty.openpty()
        fcntl.ioctl(keyboard, termios.TIOCSWINSZ, SIZE)
        self._bash = subprocess.Popen(
            ['setsid', '--ctty', 'bash', '--noprofile', '-i'], cwd=folder,
            env={**env, 'PROMPT_COMMAND': PROMPT_COMMAND},
            stdin=keyboard, stdout=keyboard, stderr=keyboard)
        os.close(keyboard)
        self._bytes = b''
        self._typed, self._line = 0, ''
        self.wait_for_prompt()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        """Close the window; the shell and what runs in it get SIGHUP.

        The system sends it, and hangs up the line too: a bash that is about to wait for a key
        would postpone a bare SIGHUP until the next key press.
        """
        self._read()
        os.close(self._screen)
        self._screen = None
        self._bash.wait(TIMEOUT * PATIENCE)

    @property
    def pid(self):
        return self._bash.pid

    @property
    def status(self):
        """The exit status of what was typed last, or None while it runs."""
        found = PROMPT.search(self.text)
        return int(found[1]) if found else None

    @property
    def lines(self):
        """What was printed since the last command was typed, up to the next prompt."""
        lines = plain_lines(PROMPT.split(self.text)[0])
        # The terminal echoes what is typed, and the shell once more if it was not ready for it.
        while self._line and lines and lines[0].endswith(self._line):
            lines.pop(0)
        return lines

    @property
    def output(self):
        return '\n'.join(self.lines[-LATEST:])

    def wait_for_prompt(self, timeout=TIMEOUT):
        wait_until(lambda: self.status is not None, timeout,
                   lambda: f'a prompt after\n{self.output}', LOOKING_PERIOD)
        return self.status

    def wait_for_output(self, text, timeout=TIMEOUT):
        wait_until(lambda: text in self.output, timeout,
                   lambda: f'{text!r} in:\n{self.output}', LOOKING_PERIOD)

    def type(self, line):
        self._read()
        self._typed, self._line = len(self._bytes), line
        os.write(self._screen, f'{line}\n'.encode())

    def press_ctrl_c(self):
        os.write(self._screen, CTRL_C)

    @property
    def text(self):
        self._read()
        return self._bytes[self._typed:].decode(errors='replace')

    def _read(self):
        """Read what is there: who prints more than a terminal holds waits until a test looks."""
        try:
            while self._screen and select.select([self._screen], [], [], 0.0)[0]:
                self._bytes += os.read(self._screen, 65536)
        except OSError:
            pass  # on Linux: the other end is closed
