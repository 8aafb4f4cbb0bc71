"""docs/reference.md says what nodes, launch files, the demo and the sweep say of themselves."""

import pytest
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


def test_an_entry_may_go_on_in_the_next_line():
    """Several names, a meaning with a parenthesis."""
    found, = reference.entries('A node.\n\nPublishes:\n'
                               '    a, ~b (std_msgs/Float64): this\n        and (m) that\n')
    assert found == reference.Entry('Publishes', 'a, ~b', 'std_msgs/Float64', 'this and (m) that')


def test_an_entry_of_another_form_is_refused():
    """It would be missing from the page."""
    with pytest.raises(AssertionError, match='a Float64'):
        reference.entries('A node.\n\nPublishes:\n    a Float64: this\n')
