"""A learner's node gets the verdict that the behaviour deserves, each time the same."""

import csv
import re
from pathlib import Path
from xml.etree import ElementTree

import pytest
import yaml
from odometry_tests.processes import Process
from odometry_tests.scripts import ROOT

NODES = Path(__file__).with_name('nodes')
# The rules by scenario, of each node and exercise; a scenario that is not named is passed.
EXPECTED = yaml.safe_load((NODES / 'expected.yaml').read_text())
TIMEOUT, CLASS_TIMEOUT = 120.0, 1800.0  # s
# These are judged in paced time, where the last digit may differ.
BUSY = re.compile('no_sleep|wall_sleep|busy_wait|forks')
PORTS = {'moved_distance': ('odom_movement_detector', 'odom_movement_detector.py'),
         'two_meters': ('test_movement', 'test_movement.py'), 'heading': ('rotate_robot', 'rotate.py')}


def check(*words, timeout=TIMEOUT, status):
    """Run a check to its end; return its Process."""
    with Process(ROOT / 'ws', 'check', *words) as process:
        assert process.wait(timeout) == status, process.output
    return process


def rows_of(path):
    """Return what a check has written for a spreadsheet."""
    with path.open(newline='') as file:
        return list(csv.DictReader(file))


@pytest.mark.parametrize('exercise, node, scenario', [
    ('heading', 'tutorial_rotate', 'moved_start'), ('heading', 'tutorial_rotate', 'interrupt'),
    ('two_meters', 'row22_elapsed_time', 'slow_base'), ('two_meters', 'row26_window', 'odom_5hz'),
    ('moved_distance', 'row18_y_copied', 'route'), ('heading', 'row04_queue_size_text', 'plain')])
def test_a_mistake_is_named_where_it_shows(tmp_path, exercise, node, scenario):
    """One of each scenario, by day."""
    file = tmp_path / 'rows.csv'
    check(exercise, NODES / exercise / f'{node}.py', '--scenario', scenario, '--csv', file, status=1)
    row, = rows_of(file)
    assert (row['scenario'], row['rule']) == (scenario, EXPECTED[exercise][node][scenario]), row


@pytest.mark.nightly
@pytest.mark.parametrize('exercise', EXPECTED)
def test_each_node_of_a_class_gets_its_verdict_twice(tmp_path, exercise):
    """Wrong ones the rule of their row, right ones of any style all scenarios."""
    first, second = (rows_of_class(tmp_path / name, exercise) for name in ('first.csv', 'second.csv'))
    found = {}
    for row in first:
        rules = found.setdefault(row['submission'][:-len('.py')], {})
        if row['rule'] != 'passed':
            rules[row['scenario']] = row['rule']
    assert found == {node: rules or {} for node, rules in EXPECTED[exercise].items()}
    assert [row for row in first if not BUSY.search(row['submission'])] == [
        row for row in second if not BUSY.search(row['submission'])]


def rows_of_class(file, exercise):
    """Return the rows of all nodes of an exercise."""
    check(exercise, NODES / exercise, '--csv', file, timeout=CLASS_TIMEOUT, status=1)
    return rows_of(file)


@pytest.mark.parametrize('exercise', [
    'heading', *(pytest.param(exercise, marks=pytest.mark.nightly)
                 for exercise in ('moved_distance', 'two_meters'))])
def test_the_ports_pass_everything(tmp_path, exercise):
    """By PACKAGE NODE; CI reads it."""
    file = tmp_path / 'junit.xml'
    run = check(exercise, *PORTS[exercise], '--junit', file, status=0)
    suite = ElementTree.parse(file).getroot()
    assert suite.get('failures') == '0'
    assert len(suite.findall('testcase')) == int(suite.get('tests')) >= 3
    assert re.search(r'(\d) of \1 passed\.$', run.stdout.strip()), run.stdout


def test_a_failure_leaves_its_recording_and_says_where(tmp_path):
    """Bag, picture and what the node printed."""
    run = check('heading', NODES / 'heading' / 'row02_undefined_name.py', status=1)
    folder = (ROOT / re.search(r'^ +(\S*check-plain\S+)$', run.stdout, re.MULTILINE)[1]).resolve()
    assert "NameError: name 'atTarget' is not defined" in (folder / 'output.txt').read_text()
    assert (folder / 'run.bag').exists()


@pytest.mark.nightly
def test_nothing_of_a_node_reaches_the_next_scenario(tmp_path):
    """A child in a session of its own drives on until it is killed."""
    file = tmp_path / 'rows.csv'
    check('two_meters', NODES / 'two_meters' / 'forks.py', '--csv', file, status=1)
    assert {row['rule'] for row in rows_of(file)} == {'passed_by', 'interrupt_ignored'}, rows_of(file)


@pytest.mark.parametrize('words, line', [
    (['heading', 'no_such_package', 'node.py'], 'there is no package no_such_package'),
    (['heading', 'rotate_robot', 'no_such.py'], 'rotate_robot has no executable file'),
    (['heading', 'no_such.py'], 'there is no file or folder no_such.py'),
    (['heading', '.', '--view'], '--view shows one node'),
    (['heading', 'x.py', '--scenario', 'slow_base'], 'heading has no scenario slow_base, but plain')])
def test_what_makes_no_sense_is_one_line(words, line):
    """And status 2."""
    run = check(*words, status=2)
    assert line in run.stderr.splitlines()[-1]
