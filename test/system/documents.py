"""The commands in a Markdown document, with what it shows of their output."""

import re
from dataclasses import dataclass, field, replace

from markdown_it import MarkdownIt
from odometry_tests.scripts import ROOT

WORDS = {'./ws', 'rosrun', 'roslaunch', 'rostopic', 'rosparam', 'rosnode', 'rosservice', 'rosbag',
         'rosmsg', 'rostest', 'rospack', 'roscore', 'rosdep', 'catkin_make', 'git', 'cd', 'mkdir',
         'pip', 'python3', 'sudo', 'apt', 'ssh', 'source', 'docker', 'podman', '.'}
PROMPT = '$ '
MORE = '...'  # what a document has for the rest of an output
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
    commands, heading = [], ''
    tokens = MarkdownIt().enable('table').parse(text)
    for before, token in zip([None, *tokens], tokens):
        if token.type == 'inline' and before.type == 'heading_open':
            heading = token.content
        if token.type == 'fence' and not token.info:  # with a language it is a file
            _read_code(token, Command('', name, heading, token.map[0] + 1, inline=False), commands)
        for child in token.children or []:
            if child.type == 'code_inline':
                text = _inline_command(child.content)
                if text:
                    commands.append(Command(text, name, heading, token.map[0] + 1, inline=True))
    return commands


def _read_code(fence, place, commands):
    """Add the commands in a block, or its output to the last one."""
    lines = fence.content.splitlines()
    prompted = any(line.startswith(PROMPT) for line in lines)
    output = not prompted and not is_command(lines[0])
    for number, line in enumerate(lines, start=place.line + 1):
        if line.startswith(PROMPT) or not (prompted or output):
            text = line[len(PROMPT):] if line.startswith(PROMPT) else line
            commands.append(replace(place, text=text, line=number, shown=[]))
        elif line and line != MORE:
            assert commands, f'{place}:{number}: this output is of no command'
            commands[-1].shown.append(line)


def _inline_command(code):
    if ARGUMENT.fullmatch(code.split()[0]):
        # Such as view:=true, which every launch file takes, or scan:=true, which sim.launch does.
        argument, tutorial = code.partition(':=')[0], 'move_two_meters.launch'
        is_usual = f'name="{argument}"' in (ROOT / 'launch' / tutorial).read_text()
        return f'roslaunch odometry_launch {tutorial if is_usual else "sim.launch"} {code}'
    return code if is_command(code) and ' ' in code else None
