"""The documents hang together, and say what is so: names, examples, the reference."""

import re

import pytest
from odometry_tests.scripts import DOCUMENTS, ROOT, SCRIPTS, load_script

LINK = re.compile(r'\]\((?!https?:)([^)#]*)(?:#([^)]*))?\)')
EXAMPLE = ROOT / 'docs/example'
reference = load_script('test/tools/reference.py')


def anchors(page):
    headings = re.findall(r'^#+ (.*)', page.read_text(), re.MULTILINE)
    return {re.sub(r'[^\w -]', '', heading.lower()).replace(' ', '-') for heading in headings}


@pytest.mark.parametrize('page', DOCUMENTS, ids=lambda page: str(page.relative_to(ROOT)))
def test_every_link_leads_somewhere(page):
    for path, anchor in LINK.findall(page.read_text()):
        file = page.parent / path if path else page
        assert file.exists(), f'{file} is not there'
        assert not anchor or anchor in anchors(file), f'{file.name} has no heading #{anchor}'


@pytest.mark.parametrize('page', ['ci.md', 'scan.md'])
def test_a_page_shows_files_of_the_example(page):
    """Whole, so that they can be copied from there."""
    files = [path.read_text() for path in EXAMPLE.rglob('*.*') if path.is_file()]
    shown = re.findall(r'^```\w+\n(.*?)^```$', (ROOT / 'docs' / page).read_text(), re.DOTALL | re.MULTILINE)
    assert shown and all(block in files for block in shown)


@pytest.mark.parametrize('file, updated', [
    (reference.PAGE, reference.updated), (reference.SIM_LAUNCH, reference.updated_launch)], ids=['page', 'launch'])
def test_what_is_generated_is_up_to_date(file, updated):
    text = file.read_text()
    assert text == updated(text), 'type ./ws python3 test/tools/reference.py'


def test_every_node_and_launch_file_has_a_heading():
    """But what ./ws demo, check and sweep start, what stands in for ROS's rosout, and what is only included."""
    nodes = {path.name for path in SCRIPTS} - {'check.py', 'demo.py', 'sweep.py', 'rosout.py'}
    launched = {path.name for path in ROOT.glob('launch/*.launch')} - {'house.launch', 'move_base.launch', 'movers.launch', 'pair.launch'}
    headings = {found[1] for found in reference.GENERATED.finditer(reference.PAGE.read_text())}
    assert nodes | launched | {*reference.PARSERS} <= headings
