"""The workflows are well formed, and documents show the files of their examples as they are."""

import re

import pytest
import yaml
from odometry_tests.scripts import ROOT

EXAMPLE = ROOT / 'docs' / 'example'
WORKFLOWS = [*ROOT.glob('.github/workflows/*.yml'), *EXAMPLE.glob('.github/workflows/*.yml')]
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


@pytest.mark.parametrize('path', WORKFLOWS, ids=lambda path: path.name)
def test_a_workflow_is_one_that_github_accepts(path):
    """As far as its structure tells; actionlint, which is no package here, tells more."""
    workflow = yaml.load(path.read_text(), yaml.BaseLoader)  # to YAML itself `on` is true
    assert {'name', 'on', 'jobs'} <= set(workflow)
    for name, job in workflow['jobs'].items():
        assert {'runs-on', 'timeout-minutes', 'steps'} <= set(job), name
        for step in job['steps']:
            assert ('run' in step) != ('uses' in step), step
            assert re.fullmatch(r'[\w-]+/[\w-]+@v\d+', step.get('uses', 'own/step@v1')), step
