"""What the documents show of a command's output: each is typed as it is shown, and its lines are compared in form."""

import re
from contextlib import ExitStack

import pytest
from odometry_tests.forms import first_missing, plain_lines
from odometry_tests.processes import Master, Process, hold_port
from odometry_tests.scripts import DOCUMENTS, ROOT
from odometry_tests.waiting import wait_until

FENCE = re.compile(r'^```(\w*)\n(.*?)^```$', re.DOTALL | re.MULTILINE)
PROMPT, BAR = '$ ', '[='  # an output without a prompt before it begins with the bar of the demo
MORE = '...'  # what a document has for the rest of an output
# No other command is typed: some install or end something. The last ones need what is not here.
TYPED = re.compile(r'(\./ws (demo|check|sweep)|ros(run|launch|topic))\b(?! (pub|one_metre|--replay))[^|]*$')
DRIVES = '## Make a map'  # in docs/navigation.md; its commands need one another
CAMPAIGN = 'launch/navigation/campaign.yaml'
NAVIGATION = ROOT / '.ws/devel/lib/move_base'
TIMEOUT = 60.0  # s
SEEDS = re.compile(r'(--seeds) \d+')  # too many for a test


def commands_in(text):
    """Return the commands in a text, each with the lines shown of its output."""
    commands = []
    for language, block in FENCE.findall(text):
        is_output = block.startswith(BAR)
        is_prompted = any(line.startswith(PROMPT) for line in block.splitlines())
        for line in block.splitlines() if not language else []:  # with a language it is a file
            if line.startswith(PROMPT) or not (is_output or is_prompted):
                commands.append((line.replace(PROMPT, '', 1), []))
            elif line != MORE:
                commands[-1][1].append(line)
    return commands


def typed_in(page):
    """Return the commands of a page that are typed, up to the last one with output."""
    commands = commands_in(page.read_text().partition(DRIVES)[0])
    while commands and not commands[-1][1]:
        commands.pop()
    return [command for command in commands if TYPED.match(command[0])]


PAGES = [page for page in DOCUMENTS if typed_in(page)]


def follow(text, shown, home, running):
    """Type a command; return once it has printed what is shown."""
    command = start(SEEDS.sub(r'\1 2', text), home, running)

    def missing():
        return first_missing(shown, plain_lines(command.output))

    wait_until(lambda: not missing() or not command.running, TIMEOUT,
               lambda: f'{missing()!r} from {text}; it printed:\n{command.output}')
    assert not missing(), f'{text}\nhas not shown {missing()!r}; it printed:\n{command.output}'


@pytest.mark.parametrize('page', [
    pytest.param(page, marks=[] if page.name == 'README.md' else pytest.mark.nightly, id=page.name) for page in PAGES])
def test_what_is_typed_prints_what_is_shown(page, tmp_path):
    with Master(), ExitStack() as running:
        for text, shown in typed_in(page):
            follow(text, shown, tmp_path, running)


@pytest.mark.nightly
@pytest.mark.skipif(not NAVIGATION.exists(), reason='docs/navigation.md builds its packages')
def test_what_is_typed_maps_the_house_and_drives_to_a_goal(tmp_path):
    """In lockstep, whose result does not depend on the machine; each launch ends the one before."""
    _, heading, page = (ROOT / 'docs/navigation.md').read_text().partition(DRIVES)
    campaign = tmp_path / 'campaign.yaml'
    campaign.write_text(re.sub('seeds: .*', 'seeds: 1', (ROOT / CAMPAIGN).read_text()))
    with Master(), hold_port() as port, ExitStack() as launched:
        for text, shown in commands_in(heading + page):
            if text.startswith(('roslaunch ', './ws sweep ')):
                launched.close()
            if text.startswith('roslaunch '):
                start(f'{text} view_port:={port} lockstep:=true real_time_factor:=0', tmp_path, launched)
                end('rostopic echo -n1 /move_base/status', [], tmp_path)  # it takes goals
            elif text.startswith('rosrun tf tf_echo '):
                with ExitStack() as echoed:
                    start(text, tmp_path, echoed).wait_for_output('- Translation: ', TIMEOUT)
            else:
                end(text.replace(CAMPAIGN, str(campaign)), shown, tmp_path)
    assert (tmp_path / 'house.pgm').exists()


def start(text, home, running):
    """Type a command in a shell; it runs until the context ends."""
    return running.enter_context(Process('bash', '-c', text, cwd=ROOT, env={'HOME': str(home)}))


def end(text, shown, home):
    """Type a command; return once it has ended well, and has printed what is shown."""
    with ExitStack() as running:
        command = start(text, home, running)
        assert command.wait(TIMEOUT) == 0, command.output
    assert not first_missing(shown, plain_lines(command.output)), command.output
