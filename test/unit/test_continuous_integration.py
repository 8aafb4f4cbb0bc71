"""The workflows are well formed, and documents show the files of their examples as they are."""

import re

from odometry_tests.scripts import ROOT

EXAMPLE = ROOT / 'docs' / 'example'
SHOWN = re.findall(r'^```\w+\n(.*?)^```$', (ROOT / 'docs' / 'ci.md').read_text(),
                   re.DOTALL | re.MULTILINE)


def test_the_page_shows_files_of_the_example():
    """Whole, so that they can be copied from there."""
    files = [path.read_text() for path in EXAMPLE.rglob('*.*') if path.is_file()]
    assert len(SHOWN) == 4
    for block in SHOWN:
        assert block in files, block


def test_the_tutorial_shows_its_node():
    """As it is."""
    block, = re.findall(r'^```python\n(.*?)^```$', (ROOT / 'docs' / 'scan.md').read_text(),
                        re.DOTALL | re.MULTILINE)
    assert block == (EXAMPLE / 'src' / 'stop_before_wall.py').read_text()
