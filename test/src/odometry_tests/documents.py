"""The commands in a Markdown document, with what it shows of their output."""

import re
from dataclasses import dataclass, field

from odometry_tests.scripts import ROOT

README = ROOT / 'README.md'
DOCUMENTS = [README, ROOT / 'CONTRIBUTING.md', *sorted(ROOT.glob('[!.]*/*.md'))]
WORDS = {'./ws', 'rosrun', 'roslaunch', 'rostopic', 'rosparam', 'rosnode', 'rosservice', 'rosbag',
         'rosmsg', 'rostest', 'rospack', 'roscore', 'rosdep', 'catkin_make', 'git', 'cd', 'mkdir',
         'pip', 'python3', 'sudo', 'apt', 'ssh', 'source', 'docker', 'podman', '.'}
FENCE = '```'
PROMPT = '$ '
MORE = '...'  # what a document has for the rest of an output
INLINE = re.compile(r'`([^`]+)`')
ARGUMENT = re.compile(r'(?<!\S)[a-z]\w*:=[^\s`A-Z]+(?!\S)')


@dataclass
class Command:
    """A command as it is printed, and where."""

    text: str
    document: str
    heading: str
    line: int
    inline: bool
    shown: list = field(default_factory=list)

    def __str__(self):
        return f'{self.document}:{self.line}: {self.text}'


def is_command(text):
    """Return whether a line begins with a word that runs something, variables before it aside."""
    words = [word for word in text.split() if not re.match(r'[A-Z_]+=', word)]
    return bool(words) and words[0] in WORDS


def read_commands(name, text):
    """Return the commands of a document in their order."""
    return _Parser(name).read(text.splitlines())


class _Parser:

    def __init__(self, document):
        self._document = document
        self._heading = ''
        self._commands = []

    def read(self, lines):
        """Go through the blocks between blank lines, fences, table rows and headings."""
        block, start, fenced, language = [], 1, False, ''
        for number, line in enumerate([*lines, ''], start=1):
            if line.startswith(FENCE):
                if not language:  # a file, not commands
                    (self._read_code if fenced else self._read_prose)(block, start)
                block, start, fenced = [], number + 1, not fenced
                language = line[len(FENCE):]
            elif fenced or (line and line[0] not in '#|'):
                block.append(line)
            else:
                self._read_prose(block, start)
                if line.startswith('#'):
                    self._heading = line.strip('# ')
                self._read_prose([line], number)
                block, start = [], number + 1
        return self._commands

    def _read_code(self, lines, start):
        prompted = any(line.startswith(PROMPT) for line in lines)
        output = not prompted and not is_command(lines[0])
        for number, line in enumerate(lines, start=start):
            if line.startswith(PROMPT) or not (prompted or output):
                command = line[len(PROMPT):] if line.startswith(PROMPT) else line
                self._add(command, number, inline=False)
            elif line and line != MORE:
                assert self._commands, f'{self._document}:{number}: this output is of no command'
                self._commands[-1].shown.append(line)

    def _read_prose(self, lines, start):
        text = '\n'.join(lines)
        for found in INLINE.finditer(text):
            code = ' '.join(found[1].split())
            number = start + text.count('\n', 0, found.start())
            if is_command(code) and ' ' in code:
                self._add(code, number, inline=True)
            elif ARGUMENT.fullmatch(code.split()[0]):
                # Such as view:=true, which the text says every launch file takes.
                self._add(f'roslaunch odometry_launch move_two_meters.launch {code}', number, True)

    def _add(self, text, number, inline):
        self._commands.append(
            Command(text, self._document, self._heading, number, inline))
