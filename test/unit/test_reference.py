"""docs/reference.md says what nodes, launch files, the demo and the sweep say of themselves."""

from odometry_tests.scripts import ROOT, load_script

reference = load_script('test/tools/reference.py')


def test_the_page_is_up_to_date():
    """The page is written by a tool, so that nothing is described twice."""
    page = reference.PAGE.read_text()
    assert page == reference.updated(page), 'type ./ws python3 test/tools/reference.py'


def test_every_node_and_launch_file_has_a_heading():
    """A new one needs a heading, and no more; movers.launch is only included by another.

    sweep.py is ./ws sweep.
    """
    nodes = {path.name for folder in ('src', 'script') for path in ROOT.glob(f'*/{folder}/*.py')}
    launched = {path.name for path in ROOT.glob('launch/*.launch')} - {'movers.launch'}
    nodes -= {'sweep.py'}
    headings = {found[1] for found in reference.GENERATED.finditer(reference.PAGE.read_text())}
    assert nodes | launched | {*reference.PARSERS} <= headings
