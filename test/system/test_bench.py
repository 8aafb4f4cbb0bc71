"""The commands of ./ws bench that the documents show, but for the time that they take."""

import csv
import os
import re
import subprocess

import pytest
from odometry_tests.documents import shown_of
from odometry_tests.forms import first_missing
from odometry_tests.linux import LOOK_PERIOD, command_lines, marked, new_mark, wait_until_none
from odometry_tests.listening import assert_loopback, listened_on
from odometry_tests.processes import Process
from odometry_tests.scripts import ROOT, load_script
from odometry_tests.waiting import wait_until

TIMEOUT = 180.0  # s


@pytest.fixture
def run_bench(monkeypatch):
    """Return the module that ./ws bench runs."""
    monkeypatch.syspath_prepend(str(ROOT / 'test' / 'benchmarks'))
    return load_script('test/benchmarks/run_bench.py')


def name_in(row):
    """Return the figure's name in a row of the table."""
    return re.split(' {2,}', row)[0]


def test_without_a_part_everything_is_measured(run_bench):
    """As ./ws bench is typed first; and with parts nothing but these."""
    assert run_bench.parse([]).only == list(run_bench.MEASUREMENTS)
    assert run_bench.parse(['--window', '1']).only == list(run_bench.MEASUREMENTS)
    assert run_bench.parse(['unpaced', 'robot']).only == ['unpaced', 'robot']


@pytest.mark.parametrize('part, names', [
    ('robot', ['robot without ROS']),
    ('lockstep', ['graph in lockstep', 'graph in lockstep, CPU time']),
    ('end', ['end of a node'])])
def test_a_part_is_measured_and_shown_as_a_table(tmp_path, part, names):
    """Name, value, limit and ratio in the table and in a file; what is missed decides the status."""
    file = tmp_path / 'figures.csv'
    with Process(ROOT / 'ws', 'bench', part, '--runs', '1', '--window', '1e-6',
                 '--csv', file) as run:
        addresses = listened_on(run, TIMEOUT)
        status = run.wait()
        assert_loopback(addresses)
    _, heading, *rows = run.stdout.splitlines()
    assert heading.split() == ['name', 'value', 'unit', 'limit', 'ratio', 'target'], run.output
    assert [name_in(row) for row in rows[:len(names)]] == names, run.output
    shown = [line for line in shown_of('./ws bench') if name_in(line) in names]
    assert first_missing(shown, rows) is None
    with open(file, newline='') as lines:
        values = {row['name']: float(row['value']) for row in csv.DictReader(lines)}
    assert list(values) == names
    # Only the first: in so short a window a graph may have no tick of CPU time.
    assert values[names[0]] > 0, values
    missed = re.search('^targets missed: (.*)', run.stdout, re.MULTILINE).group(1)
    assert status == (0 if missed == 'none' else 1), run.output


def test_nothing_is_left_of_a_bench_that_is_killed():
    """By kill -9, while its graph runs."""
    mark = new_mark()
    with subprocess.Popen([ROOT / 'ws', 'bench', 'lockstep'], stdout=subprocess.DEVNULL,
                          env={**os.environ, **mark}) as bench_of_graph:
        wait_until(lambda: 'sim_turtlebot_node.py' in command_lines(marked(mark)), TIMEOUT,
                   'a robot', LOOK_PERIOD)
        bench_of_graph.kill()
    wait_until_none(mark)


def test_help_names_every_part(run_bench):
    """So that nobody has to guess."""
    run = Process(ROOT / 'ws', 'bench', '--help')
    assert run.wait(TIMEOUT) == 0, run.output
    assert ','.join(run_bench.MEASUREMENTS) in re.sub(r'\s', '', run.stdout)


@pytest.mark.parametrize('arguments', [['--view'], ['dance'], ['--runs', '0'], ['--runs', '1.5'],
                                       ['--window', '-1'], ['--window', 'nan']])
def test_bad_options_get_one_clear_line(run_bench, monkeypatch, capsys, arguments):
    """And exit status 2, before anything is started."""
    monkeypatch.setattr('sys.argv', ['run_bench.py', *arguments])
    with pytest.raises(SystemExit) as end:
        run_bench.main()
    assert end.value.code == 2
    assert capsys.readouterr().err.splitlines()[-1].startswith('./ws bench: error: ')
