"""The linters in .pre-commit-config.yaml find nothing."""

import re

import pytest
import yaml
from odometry_tests.processes import run
from odometry_tests.scripts import ROOT

CONFIG = yaml.safe_load((ROOT / '.pre-commit-config.yaml').read_text())
HOOKS = [hook['id'] for repository in CONFIG['repos'] for hook in repository['hooks']]
TIMEOUT = 150.0  # s
SLOW = {'vermin', 'roslaunch-check'}


def test_no_option_can_be_abbreviated():
    """./ws installs what an option needs by its whole name."""
    calls = {path: re.findall(r'ArgumentParser\((?:[^()]|\([^()]*\))*\)', path.read_text())
             for path in ROOT.glob('[!.]*/**/*.py')}
    assert any(calls.values())
    assert [path for path, found in calls.items() if any('allow_abbrev=False' not in call for call in found)] == []


@pytest.mark.skipif(not (ROOT / '.git').exists(), reason='pre-commit needs a clone')
@pytest.mark.parametrize('hook', [
    pytest.param(hook, marks=pytest.mark.nightly if hook in SLOW else []) for hook in HOOKS])
def test_a_linter_finds_nothing(hook, tmp_path):
    run('pre-commit', 'run', '--all-files', '--color=never', hook, cwd=ROOT, timeout=TIMEOUT,
        env={'PRE_COMMIT_HOME': str(tmp_path)})
