"""The example of docs/ci.md, set up and run as its workflow does."""

import pytest
import yaml
from checkout import in_checkout, make_checkout
from odometry_tests.processes import run
from odometry_tests.scripts import ROOT

EXAMPLE = ROOT / 'docs/example'
WORKFLOW = yaml.safe_load((EXAMPLE / '.github/workflows/robot.yml').read_text())
COPY, TEST = [step['run'] for step in WORKFLOW['jobs']['robot']['steps'] if 'run' in step][-2:]
CLONE = '/robot'
# What ./ws does before a command, with the virtual environment of this project.
RUN = """
has_requirements() { true; }
set_up true
export ODOMETRY_ROOT=$ROOT
set +u
. "$ROOT/tools/setup/enter.bash"
"""


@pytest.fixture(scope='module')
def checkout(tmp_path_factory):
    folder = make_checkout(tmp_path_factory.mktemp('machine') / 'robot')
    run('bash', '-c', COPY.replace(CLONE, str(folder)), cwd=EXAMPLE)
    return folder


@pytest.mark.nightly
@pytest.mark.parametrize('distance, passes', [('1.0', True), ('1.1', False)])
def test_the_workflow_tells_a_node_that_stops_from_one_that_drives_on(checkout, distance, passes):
    node = checkout / '.ws/src/one_metre/src/one_metre.py'
    original = (EXAMPLE / 'src/one_metre.py').read_text()
    assert 'DISTANCE = 1.0 ' in original
    node.write_text(original.replace('DISTANCE = 1.0 ', f'DISTANCE = {distance} '))
    ended = in_checkout(checkout, RUN + TEST.replace(f'{CLONE}/ws ', ''), status=None)
    assert (ended.wait() == 0) == passes, ended.output
    assert f'RESULT: {"SUCCESS" if passes else "FAIL"}' in ended.stdout, ended.output
    assert passes or '!= 1.015 within 0.015 delta' in ended.output, ended.output
