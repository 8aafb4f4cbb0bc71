"""./ws bench measures, says honestly what is missed, and leaves nothing behind."""

import csv
import re

import pytest
from odometry_tests.processes import Process
from odometry_tests.scripts import ROOT

TIMEOUT = 180.0  # s


@pytest.mark.nightly
def test_figures_are_measured_and_shown_as_a_table(tmp_path):
    """Name, value, limit and ratio in the table and in a file; the status says what is missed."""
    file = tmp_path / 'figures.csv'
    with Process(ROOT / 'ws', 'bench', 'robot', 'lockstep', '--runs', '1', '--window', '1e-6',
                 '--csv', file) as run:
        status = run.wait(TIMEOUT)
    _, heading, *rows = run.stdout.splitlines()
    assert heading.split() == ['name', 'value', 'unit', 'limit', 'ratio', 'target'], run.output
    with open(file, newline='') as lines:
        figures = list(csv.DictReader(lines))
    assert [figure['name'] for figure in figures] == ['robot without ROS', 'graph in lockstep']
    assert all(float(figure['value']) > 0 for figure in figures), figures
    missed = [re.split(' {2,}', row)[0] for row in rows if row.endswith('  MISSED')]
    assert f'targets missed: {", ".join(missed) or "none"}' in run.stdout, run.output
    assert status == (1 if missed else 0), run.output
