"""Somebody who types a section's commands into terminals, and looks at what they print."""

import contextlib
import re
import shlex

from odometry_tests.forms import first_missing
from odometry_tests.processes import ATTEMPTS, GAVE_UP
from odometry_tests.scripts import ROOT
from odometry_tests.signs import Graph, lacks, objection
from odometry_tests.terminal import Terminal
from odometry_tests.waiting import wait_until

TIMEOUT = 45.0  # s; a demo takes 26
LONG_TIMEOUT = 240.0  # s, for what keeps the processors busy until it ends
LONG = ('./ws sweep', './ws bench')
LOOKING_PERIOD = 0.2  # s; each look asks the master and goes through all that was printed
ENDS_WELL = {0, 130}  # 130: whom Ctrl-C has ended
PLAIN = ('./ws', 'git')  # what is typed before there is a shell in the workspace
# The last is said of an unknown parameter.
UNWANTED = ['Traceback (most recent call last)', 'has died', 'command not found', 'unknown: ']


class Reader:
    """A context in which commands are followed; at its end nothing of them runs any more."""

    def __init__(self, home, env, in_shell=True):
        """Take a folder for ~, an environment, and whether the terminals are in ./ws shell."""
        self._env = {**env, 'HOME': str(home)}
        self._in_shell = in_shell
        self._graph = Graph(env['ROS_MASTER_URI'])
        self._running = []  # words and terminal
        self._idle = []

    def __enter__(self):
        """Begin without a terminal."""
        return self

    def __exit__(self, kind=None, *_):
        """Press Ctrl-C in every terminal, the last one first, and close all.

        How the commands then end is judged only if nothing was amiss before.
        """
        terminals = [*self._idle, *(terminal for _, terminal in self._running)]
        with contextlib.ExitStack() as stack:
            for terminal in terminals:
                stack.push(terminal)
            for running in list(self._running):
                stack.callback(self._interrupt if kind is None else self._press_ctrl_c, running)

    def follow(self, text, shown=()):
        """Type a command; return once it has ended well or is at work, and has printed `shown`."""
        words = words_of(text)
        for running in [running for running in self._running if _role(running[0]) == _role(words)]:
            self._interrupt(running)
        self._wait_for_sense(words)
        terminal = self._terminal(text)
        self._running.append((words, terminal))
        for _ in range(ATTEMPTS):
            self._type(text, words, shown, terminal)
            if terminal.status is None or GAVE_UP not in terminal.text:
                break
        if terminal.status is not None:
            self._check_end(text, shown, terminal)
            self._running.remove((words, terminal))
            self._idle.append(terminal)

    def _type(self, text, words, shown, terminal):
        """Type a command; return once it has ended, or is at work and has printed `shown`."""
        nodes = self._graph.nodes()
        terminal.type(text)
        wait_until(lambda: terminal.status is not None
                   or not self._missing(words, shown, terminal, nodes),
                   LONG_TIMEOUT if text.startswith(LONG) else TIMEOUT,
                   lambda: f'{text}\nhas not shown {self._missing(words, shown, terminal, nodes)}; '
                           f'it printed:\n{terminal.output}', LOOKING_PERIOD)

    def _missing(self, words, shown, terminal, nodes):
        line = first_missing(shown, terminal.lines)
        return lacks(words, terminal, self._graph, nodes) if line is None else f'{line!r}'

    def _wait_for_sense(self, words):
        wait_until(lambda: not objection(words, self._graph), TIMEOUT,
                   lambda: f'{" ".join(words)}: {objection(words, self._graph)}', LOOKING_PERIOD)

    def _check_end(self, text, shown, terminal):
        accepted = {0, 1} if text.startswith('./ws bench') else {0}  # 1: a target is missed
        assert terminal.status in accepted, \
            f'{text}\nended with {terminal.status}; it printed:\n{terminal.output}'
        line = first_missing(shown, terminal.lines)
        assert line is None, \
            f'{text}\nhas not printed a line like\n{line}\nbut:\n{terminal.output}'

    def _interrupt(self, running):
        words, terminal = running
        status = self._press_ctrl_c(running)
        found = [unwanted for unwanted in UNWANTED if unwanted in terminal.output]
        assert status in ENDS_WELL and not found, \
            f'{" ".join(words)}\nended with {status}; it printed:\n{terminal.output}'
        self._running.remove(running)
        self._idle.append(terminal)

    @staticmethod
    def _press_ctrl_c(running):
        """Return the status with which the command has ended."""
        _, terminal = running
        if terminal.status is None:
            terminal.press_ctrl_c()
        return terminal.wait_for_prompt()

    def _terminal(self, text):
        """Return a terminal in which nothing runs."""
        in_shell = self._in_shell and not text.startswith(PLAIN)
        fits = [terminal for terminal in self._idle if terminal.in_shell == in_shell]
        if fits:
            self._idle.remove(fits[-1])
            return fits[-1]
        terminal = Terminal(ROOT, self._env)
        terminal.in_shell = in_shell
        if in_shell:
            terminal.type('./ws shell')
            terminal.wait_for_prompt()
        return terminal


def words_of(text):
    """Return the words of a command without variables before it and a comment behind it."""
    words = shlex.split(text, comments=True)
    while re.match(r'[A-Z_]+=', words[0]):
        words.pop(0)
    if words[0] == './ws' and words[1:2] == ['--host']:
        del words[1:3]
    # In the workspace is in the workspace, whether by a shell or by a single command.
    if words[0] == './ws' and words[1:] and words[1].startswith('ros'):
        words.pop(0)
    return words


def _role(words):
    """Return what a reader has only one of: who types another ends the first with Ctrl-C."""
    if '--help' in words:
        return object()
    if words[0] == 'roslaunch' or words[:2] == ['./ws', 'demo']:
        return 'launch'
    if words[0] == 'rosrun':
        return words[1:3]
    if words[0] == 'python3' or words[:2] == ['rostopic', 'echo']:
        return words[:2]
    return object()
