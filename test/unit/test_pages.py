"""The documents hang together, and what they name exists."""

import re

import pytest
from odometry_tests.documents import DOCUMENTS
from odometry_tests.scripts import ROOT

LINK = re.compile(r'\]\((?!https?:)([^)#]*)(?:#([^)]*))?\)')
TEST = re.compile(r'`(test_\w+|\w+\.test)`')


def links(page):
    """Return the files to which a page links, and the anchors in them."""
    return [(page.parent / path if path else page, anchor)
            for path, anchor in LINK.findall(page.read_text())]


def anchors(page):
    """Return what GitHub names the headings of a page."""
    headings = re.findall(r'^#+ (.*)', page.read_text(), re.MULTILINE)
    return {re.sub(r'[^\w -]', '', heading.lower()).replace(' ', '-') for heading in headings}


@pytest.mark.parametrize('page', DOCUMENTS, ids=lambda page: str(page.relative_to(ROOT)))
def test_every_link_leads_somewhere(page):
    """To a file, and to a heading in it."""
    for file, anchor in links(page):
        assert file.exists(), f'{file} is not there'
        assert not anchor or anchor in anchors(file), f'{file.name} has no heading #{anchor}'


def test_each_test_that_reliability_names_exists():
    """A fault is shown by something."""
    named = set(TEST.findall((ROOT / 'docs' / 'reliability.md').read_text()))
    tests = [path for folder in ('test', '*/test') for path in ROOT.glob(f'{folder}/**/*test*')]
    there = {path.stem if path.suffix == '.py' else path.name for path in tests}
    assert named and named <= there, sorted(named - there)


def test_everything_that_is_installed_is_named_where_it_is_removed():
    """docs/install.md, against the lists in the set-up."""
    set_up = (ROOT / 'setup' / 'set_up.bash').read_text()
    installed = re.findall(r'^\w+_PARTS=\(([^)]*)\)', set_up, re.MULTILINE)
    removed = re.findall(r'^sudo apt-mark auto (.*)', (ROOT / 'docs' / 'install.md').read_text(),
                         re.MULTILINE)
    assert sorted(' '.join(removed).split()) == sorted(' '.join(installed).split())
