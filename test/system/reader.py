"""A reader who types the commands of a section into terminals, and checks what they print."""

import contextlib
import re
import shlex

import rosgraph
from odometry_tests.forms import first_missing
from odometry_tests.links import RECEIVES, connected_topics
from odometry_tests.scripts import ROOT
from odometry_tests.terminal import Terminal
from odometry_tests.waiting import wait_until

TIMEOUT = 45.0  # s; a demo takes 26
LONG_TIMEOUT = 240.0  # s, for what keeps the processors busy until it ends
LONG = ('./ws sweep', './ws bench', './ws check', 'rostopic echo -n1 /move_base/result')
LOOKING_PERIOD = 0.2  # s; each look asks the master and goes through all that was printed
ENDS_WELL = {0, 130}  # 130: whom Ctrl-C has ended
PLAIN = ('./ws', 'git')  # what is typed before there is a shell in the workspace
# The last is said of an unknown parameter.
UNWANTED = ['Traceback (most recent call last)', 'has died', 'command not found', 'unknown: ']
# What runs until Ctrl-C, as a node or with nodes.
GOES_ON = re.compile(r'(roscore|rosrun|roslaunch|python3|rosbag record|rostopic (echo|pub -r\S*))( |$)')


class Reader:
    """A context in which commands are followed; at its end nothing of them runs any more."""

    def __init__(self, home, env, in_shell=True):
        """Take a folder for ~, an environment, and whether the terminals are in ./ws shell."""
        self._env = {**env, 'HOME': str(home)}
        self._in_shell = in_shell
        self._master = rosgraph.Master('/documents', env['ROS_MASTER_URI'])
        self._running = []  # words and terminal
        self._idle = []

    def __enter__(self):
        return self

    def __exit__(self, kind=None, *_):
        """Press Ctrl-C in every terminal, the last one first, and close all.

        Checks how the commands end only if nothing has failed before.
        """
        terminals = [*self._idle, *(terminal for _, terminal in self._running)]
        with contextlib.ExitStack() as stack:
            for terminal in terminals:
                stack.push(terminal)
            for running in list(self._running):
                stack.callback(self._interrupt if kind is None else press_ctrl_c, running)

    def follow(self, text, shown=()):
        """Type a command; return once it has ended well or is at work, and has printed `shown`."""
        words = words_of(text)
        for running in [running for running in self._running if _role(running[0]) == _role(words)]:
            self._interrupt(running)
        wait_until(lambda: not self._objection(words), TIMEOUT,
                   lambda: f'{text}: {self._objection(words)}', LOOKING_PERIOD)
        terminal = self._terminal(text)
        self._running.append((words, terminal))
        before = self._nodes()
        terminal.type(text)
        wait_until(lambda: terminal.status is not None
                   or not self._missing(words, shown, terminal, before),
                   LONG_TIMEOUT if text.startswith(LONG) else TIMEOUT,
                   lambda: f'{text}\nhas not shown {self._missing(words, shown, terminal, before)}; '
                           f'it printed:\n{terminal.output}', LOOKING_PERIOD)
        if terminal.status is not None:
            expected = int(text.startswith('./ws bench') and ' MISSED' in terminal.output)
            line = first_missing(shown, terminal.lines)
            assert terminal.status == expected and line is None, \
                f'{text}\nended with {terminal.status}, without {line!r}; it printed:\n{terminal.output}'
            self._running.remove((words, terminal))
            self._idle.append(terminal)

    def _missing(self, words, shown, terminal, before):
        """Return what a running command has not shown yet, or None if it is at work."""
        if line := first_missing(shown, terminal.lines):
            return repr(line)
        if words[:2] == ['./ws', 'demo']:
            return None if re.search(r'\[=* *\] ', terminal.output) else 'a line of progress'
        if not GOES_ON.match(' '.join(words)):
            return 'its end'
        nodes = self._nodes() - before
        launched = {f'/{name}' for name in re.findall(r'process\[(\S+)-\d+\]: started', terminal.text)}
        if not nodes or any(not str(nodes).count(name) for name in launched):
            return f'nodes beside {sorted(before)}'
        # A node of bare rospy may hang if Ctrl-C comes while it registers a topic.
        if words[:2] == ['rostopic', 'echo'] and '---' not in terminal.lines:
            return 'a message'
        if words[0] == 'python3' and not any(map(self._receives, nodes)):
            return f'a message to {sorted(nodes)}'
        return None

    def _objection(self, words):
        """Return why a command would do nothing and yet succeed, or None."""
        _, subscribed, services = map(dict, self._state())
        if words[:2] == ['rostopic', 'pub'] and words[3] not in subscribed:
            return f'nobody listens to {words[3]}'
        if words[:2] == ['rosservice', 'call'] and words[2] not in services:
            return f'there is no service {words[2]}'
        from roslaunch.arg_dump import get_args  # takes long to import
        files = [str(ROOT / 'launch' / word) for word in words
                 if word.endswith('.launch') and (ROOT / 'launch' / word).exists()]
        unknown = {word.partition(':=')[0] for word in words if ':=' in word}.difference(
            *(get_args([file]) for file in files))
        return f'there is no argument {unknown}' if files and unknown else None

    def _state(self):
        """Return who publishes, who subscribes and who serves; nobody before there is a master."""
        return self._master.getSystemState() if self._master.is_online() else ([], [], [])

    def _nodes(self):
        return {node for kind in self._state() for _, nodes in kind for node in nodes}

    def _receives(self, node):
        with contextlib.suppress(rosgraph.MasterError, OSError):  # until the node answers
            return connected_topics(node, RECEIVES, self._master.master_uri) - {'/clock'}

    def _interrupt(self, running):
        words, terminal = running
        status = press_ctrl_c(running)
        found = [unwanted for unwanted in UNWANTED if unwanted in terminal.output]
        assert status in ENDS_WELL and not found, \
            f'{" ".join(words)}\nended with {status}; it printed:\n{terminal.output}'
        self._running.remove(running)
        self._idle.append(terminal)

    def _terminal(self, text):
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


def press_ctrl_c(running):
    _, terminal = running
    if terminal.status is None:
        terminal.press_ctrl_c()
    return terminal.wait_for_prompt()


def words_of(text):
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
    """Return a key: a command ends an earlier one with the same key by Ctrl-C."""
    if '--help' in words:
        return object()
    if words[0] == 'roslaunch' or words[:2] == ['./ws', 'demo']:
        return 'launch'
    if words[0] == 'rosrun':
        return words[1:3]
    if words[0] == 'python3' or words[:2] == ['rostopic', 'echo']:
        return words[:2]
    return object()
