"""./ws bench measures, says honestly what is missed, and leaves nothing behind."""

import csv
import os
import re
import subprocess

from odometry_tests.linux import LOOK_PERIOD, command_lines, marked, new_mark, wait_until_none
from odometry_tests.processes import Process
from odometry_tests.scripts import ROOT
from odometry_tests.waiting import wait_until

TIMEOUT = 180.0  # s


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


def test_nothing_is_left_of_a_bench_that_is_killed():
    """By kill -9, while its graph runs."""
    mark = new_mark()
    with subprocess.Popen([ROOT / 'ws', 'bench', 'lockstep'], stdout=subprocess.DEVNULL,
                          env={**os.environ, **mark}) as bench_of_graph:
        wait_until(lambda: 'sim_turtlebot_node.py' in command_lines(marked(mark)), TIMEOUT,
                   'a robot', LOOK_PERIOD)
        bench_of_graph.kill()
    wait_until_none(mark)
