"""What the documents show of a command's output: each is typed as it is shown, and its lines are compared in form."""

import re
from contextlib import ExitStack

import pytest
from odometry_tests.forms import first_missing, plain_lines
from odometry_tests.processes import Master, Process
from odometry_tests.scripts import DOCUMENTS, ROOT
from odometry_tests.waiting import wait_until

FENCE = re.compile(r'^```(\w*)\n(.*?)^```$', re.DOTALL | re.MULTILINE)
PROMPT, BAR = '$ ', '[='  # an output without a prompt before it begins with the bar of the demo
MORE = '...'  # what a document has for the rest of an output
# No other command is typed: some install or end something. The last ones need what is not here, or a drive to a goal.
TYPED = re.compile(r'(\./ws (demo|check|sweep)|ros(run|launch|topic))\b(?! (pub|one_metre|--replay))(?!.*(map|navigate|move_base))[^|]*$')
NAVIGATION = ROOT / '.ws' / 'devel' / 'lib' / 'move_base'
TIMEOUT = 60.0  # s
SEEDS = re.compile(r'(--seeds) \d+')  # too many for a test


def commands_in(page):
    """Return the commands of a page up to the last one with output, each with the lines shown of it."""
    commands = []
    for language, block in FENCE.findall(page.read_text()):
        is_output = block.startswith(BAR)
        is_prompted = any(line.startswith(PROMPT) for line in block.splitlines())
        for line in block.splitlines() if not language else []:  # with a language it is a file
            if line.startswith(PROMPT) or not (is_output or is_prompted):
                commands.append((line.replace(PROMPT, '', 1), []))
            elif line != MORE:
                commands[-1][1].append(line)
    while commands and not commands[-1][1]:
        commands.pop()
    return [command for command in commands if TYPED.match(command[0])]


PAGES = [page for page in DOCUMENTS if commands_in(page)]


def follow(text, shown, home, running):
    """Type a command; return once it has printed what is shown."""
    command = running.enter_context(Process('bash', '-c', SEEDS.sub(r'\1 2', text), cwd=ROOT, env={'HOME': home}))

    def missing():
        return first_missing(shown, plain_lines(command.output))

    wait_until(lambda: not missing() or not command.running, TIMEOUT,
               lambda: f'{missing()!r} from {text}; it printed:\n{command.output}')
    assert not missing(), f'{text}\nhas not shown {missing()!r}; it printed:\n{command.output}'


@pytest.mark.parametrize('page', [
    pytest.param(page, marks=[] if page.name == 'README.md' else pytest.mark.nightly, id=page.name) for page in PAGES])
def test_what_is_typed_prints_what_is_shown(page, tmp_path):
    if page.name == 'navigation.md' and not NAVIGATION.exists():
        pytest.skip('docs/navigation.md builds its packages')
    with Master(), ExitStack() as running:
        for text, shown in commands_in(page):
            follow(text, shown, str(tmp_path), running)
