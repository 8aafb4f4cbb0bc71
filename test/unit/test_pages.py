"""The documents hang together, and say what is so: names, examples, the reference."""

import re

import pytest
from odometry_tests.scripts import DOCUMENTS, ROOT, SCRIPTS, load_script

LINK = re.compile(r'\]\((?!https?:)([^)#]*)(?:#([^)]*))?\)')
EXAMPLE = ROOT / 'docs' / 'example'
reference = load_script('test/tools/reference.py')


def links(page):
    return [(page.parent / path if path else page, anchor)
            for path, anchor in LINK.findall(page.read_text())]


def anchors(page):
    headings = re.findall(r'^#+ (.*)', page.read_text(), re.MULTILINE)
    return {re.sub(r'[^\w -]', '', heading.lower()).replace(' ', '-') for heading in headings}


@pytest.mark.parametrize('page', DOCUMENTS, ids=lambda page: str(page.relative_to(ROOT)))
def test_every_link_leads_somewhere(page):
    for file, anchor in links(page):
        assert file.exists(), f'{file} is not there'
        assert not anchor or anchor in anchors(file), f'{file.name} has no heading #{anchor}'


def test_an_administrator_installs_what_the_set_up_would():
    """docs/class.md: the line to paste, and the packages to append to it."""
    setup = (ROOT / 'tools' / 'setup' / 'set_up.bash').read_text()
    parts = {name: set(words.split()) for name, words in re.findall(r'^(\w+)_PARTS=\((.*?)\)', setup, re.DOTALL | re.MULTILINE)}
    page = (ROOT / 'docs' / 'class.md').read_text()
    line, = re.findall(r'apt-get install -y --no-install-recommends ([^\']*)', page)
    assert set(line.split()) == parts['DEBIAN'] | {'ca-certificates', 'git'}
    appended = re.findall(r'`([^`]*)`', re.search(r'^Append .*?\.', page, re.DOTALL | re.MULTILINE)[0])
    assert {'rviz', *parts['WINDOW'], 'libtf-dev', 'tf-tools'} == set(' '.join(appended).split()) - {'rosrun', 'tf'}


@pytest.mark.parametrize('page, number', [('ci.md', 1), ('scan.md', 1)])
def test_a_page_shows_files_of_the_example(page, number):
    """Whole, so that they can be copied from there."""
    files = [path.read_text() for path in EXAMPLE.rglob('*.*') if path.is_file()]
    shown = re.findall(r'^```\w+\n(.*?)^```$', (ROOT / 'docs' / page).read_text(), re.DOTALL | re.MULTILINE)
    assert len(shown) == number
    for block in shown:
        assert block in files, block


@pytest.mark.parametrize('file, updated', [
    (reference.PAGE, reference.updated), (reference.SIM_LAUNCH, reference.updated_launch)], ids=['page', 'launch'])
def test_what_is_generated_is_up_to_date(file, updated):
    text = file.read_text()
    assert text == updated(text), 'type ./ws python3 test/tools/reference.py'


def test_the_tutorials_launch_files_have_the_few_arguments_that_a_learner_changes():
    base = reference._arguments('sim.launch')
    defaults = {name: default for name, (default, _) in base.items()}
    for tutorial in 'move_two_meters.launch', 'rotate.launch':
        shared = {name: default for name, (default, _) in reference._arguments(tutorial).items()
                  if name in base}
        assert shared.items() <= defaults.items() and 'params' in shared and len(shared) <= 13


def test_every_node_and_launch_file_has_a_heading():
    """A new one needs a heading, and no more; some launch files are only included by others.

    check.py, demo.py and sweep.py are ./ws check, ./ws demo and ./ws sweep; rosout.py stands in for ROS's own.
    """
    nodes = {path.name for path in SCRIPTS}
    launched = {path.name for path in ROOT.glob('launch/*.launch')} - {'house.launch', 'move_base.launch', 'movers.launch'}
    nodes -= {'check.py', 'demo.py', 'sweep.py', 'rosout.py'}
    headings = {found[1] for found in reference.GENERATED.finditer(reference.PAGE.read_text())}
    assert nodes | launched | {*reference.PARSERS} <= headings
