"""docs/reference.md says what nodes, launch files, the demo and the sweep say of themselves."""

import pytest
from odometry_tests.scripts import ROOT, load_script
from sim_turtlebot.settings import PARAMETERS

reference = load_script('test/tools/reference.py')


def test_the_page_is_up_to_date():
    """The page is written by a tool, so that nothing is described twice."""
    page = reference.PAGE.read_text()
    assert page == reference.updated(page), 'type ./ws python3 test/tools/reference.py'


@pytest.mark.parametrize('launch_file', ['sim.launch', 'move_two_meters.launch', 'rotate.launch'])
def test_every_parameter_of_the_simulator_is_an_argument_of_the_launch_files(launch_file):
    """With the same default; a file that includes one may set each. rotate.py turns a single robot."""
    arguments = {name: default for name, (default, _) in reference._arguments(launch_file).items()}
    defaults = {row.name[1:]: str(row.default) for row in PARAMETERS.rows
                if (launch_file, row.name) != ('rotate.launch', '~robots')}
    assert arguments.items() >= {name: {'False': 'false', 'True': 'true'}.get(default, default)
                                 for name, default in defaults.items()}.items()


def test_every_node_and_launch_file_has_a_heading():
    """A new one needs a heading, and no more; movers.launch is only included by another.

    sweep.py is ./ws sweep.
    """
    nodes = {path.name for folder in ('src', 'script') for path in ROOT.glob(f'*/{folder}/*.py')}
    launched = {path.name for path in ROOT.glob('launch/*.launch')} - {'movers.launch'}
    nodes -= {'sweep.py'}
    headings = {found[1] for found in reference.GENERATED.finditer(reference.PAGE.read_text())}
    assert nodes | launched | {*reference.PARSERS} <= headings
