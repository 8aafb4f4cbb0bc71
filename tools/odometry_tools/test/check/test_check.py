"""A learner's node gets the verdict that the behaviour deserves, each time the same."""

import re
import signal
from xml.etree import ElementTree

import pytest
from learners import VARIANTS, expected, write
from odometry_tests.forms import rows_of
from odometry_tests.linux import marked
from odometry_tests.processes import Process, run
from odometry_tests.scripts import ROOT
from odometry_tests.waiting import wait_until

TIMEOUT = 300.0  # s
# These are judged at a pace, where the last digit may differ.
BUSY = re.compile('no_sleep|forks')
KILLER = 'import os, signal\nos.killpg(os.getpgid(os.getppid()), signal.SIGKILL)\n'


def check(*words, timeout=TIMEOUT, **options):
    return run(ROOT / 'ws', 'check', *words, timeout=timeout, **options)


def found_in(row):
    """Return rule and hint of a row, as variants.yaml has them."""
    return f'{row["rule"]} {row["hint"]}'.strip()


@pytest.mark.parametrize('exercise, node, scenario', [
    ('heading', 'tutorial_rotate', 'interrupt'), ('heading', 'quaternion_itself', 'plain'), ('two_meters', 'right_resets_odometry', 'moved_start'),
    ('two_meters', 'callback_beats_hook', 'interrupt'), ('two_meters', 'queue_text', 'plain'), ('two_meters', 'type_of_input', 'slow_base'),
    ('moved_distance', 'once_a_second', 'odom_5hz')])
def test_a_node_gets_its_verdict(tmp_path, exercise, node, scenario):
    """One of each scenario, by day."""
    file, = write(tmp_path, exercise, node)
    wanted = expected(exercise, node, scenario)
    rows = tmp_path / 'rows.csv'
    check(exercise, file, '--scenario', scenario, '--csv', rows, status=int(wanted != 'passed'))
    assert [found_in(row) for row in rows_of(rows)] == [wanted]


@pytest.mark.nightly
@pytest.mark.parametrize('exercise', VARIANTS)
def test_each_node_of_a_class_gets_its_verdict_twice(tmp_path, exercise):
    """To the byte."""
    write(tmp_path, exercise, *VARIANTS[exercise])
    file, looks = tmp_path / 'rows.csv', []
    for _ in range(2):
        check(exercise, tmp_path, '--csv', file, timeout=3600.0, status=1)
        looks.append(rows_of(file))
    first, second = looks
    found = {(row['submission'], row['scenario']): found_in(row) for row in first}
    assert found == {(name, scenario): expected(exercise, name[:-len('.py')], scenario) for name, scenario in found}
    assert [row for row in first if not BUSY.search(row['submission'])] == [
        row for row in second if not BUSY.search(row['submission'])]


def test_a_submission_that_kills_its_check_stops_no_other(tmp_path):
    """Its row says so, and the file has the others, here a folder each; nobody is left out."""
    for name in 'anna', 'ben', 'cleo', '__MACOSX':
        (tmp_path / name).mkdir()
    (tmp_path / 'anna/kills.py').write_text(KILLER)
    write(tmp_path / 'ben', 'two_meters', 'main_not_called')
    (tmp_path / 'dora.zip').touch()
    file = tmp_path / 'rows.csv'
    ran = check('two_meters', tmp_path, '--scenario', 'plain', '--csv', file, status=1)
    killed, other, empty = rows_of(file)
    assert (killed['submission'], killed['sentence']) == ('anna/kills.py', 'the check ended by a signal (Killed)')
    assert (other['submission'], found_in(other)) == ('ben/main_not_called.py', 'no_node main')
    assert empty['submission'] == 'cleo' and empty['sentence'].endswith('cleo has no file *.py and no package')
    assert 'left out: dora.zip' in ran.stderr


@pytest.mark.parametrize('signum, target', [(signal.SIGINT, 'node.py'), (signal.SIGTERM, '')])
def test_a_signal_ends_a_check_and_all_of_its_processes(tmp_path, signum, target, mark):
    """In the scenarios of one node, or in a class, which run side by side."""
    (tmp_path / 'node.py').write_text(f'open({str(tmp_path / "here")!r}, "w")\nwhile True:\n    pass\n')
    with Process(ROOT / 'ws', 'check', 'heading', tmp_path / target) as process:
        wait_until((tmp_path / 'here').exists, TIMEOUT, lambda: process.output)
        assert process.end(signum, timeout=5.0) == 128 + signum, process.output
    assert not marked(mark)


@pytest.mark.parametrize('exercise, words', [
    ('heading', ['rotate_robot', 'rotate.py']), *(pytest.param(*case, marks=pytest.mark.nightly) for case in [
        ('moved_distance', ['odom_movement_detector', 'odom_movement_detector.py']),
        ('two_meters', ['test_movement', 'test_movement.py']),
        ('two_meters', [ROOT / 'docs/example/src/one_metre.py', '_distance:=2'])])])
def test_our_nodes_pass_everything(tmp_path, exercise, words):
    """The ports by PACKAGE NODE, and the example of the documents; CI reads it."""
    file = tmp_path / 'junit.xml'
    ran = check(exercise, *words, '--junit', file)
    suite = ElementTree.parse(file).getroot()
    assert suite.get('failures') == '0'
    assert len(suite.findall('testcase')) == int(suite.get('tests')) >= 3
    assert re.search(r'(\d) of \1 passed\.$', ran.stdout.strip()), ran.stdout


def test_a_failure_leaves_its_recording_and_quotes_what_any_parser_reads(tmp_path, monkeypatch):
    """Without colours and addresses; the folder has the same name each time.

    The master has an address that no terminal finds: else what waits for one at the usual would be judged, too.
    """
    usual = 'http://localhost:12311'  # below what the kernel gives to who asks for any port
    monkeypatch.setenv('ROS_MASTER_URI', usual)
    file, = write(tmp_path, 'two_meters', 'ends_at_once')
    junit = tmp_path / 'junit.xml'
    ran = check('two_meters', file, '_x:=1', '__ns:=mine', '--scenario', 'plain', '--junit', junit, status=1)
    failure, = ElementTree.parse(junit).getroot().iter('failure')
    assert failure.get('message').endswith('It said last: no gyro at 0x..., giving up')
    folder = ROOT / re.search(r'^ +(\S*check-two_meters-\S*ends_at_once.py-\S*plain)$', ran.stdout, re.MULTILINE)[1]
    said = (folder.resolve() / 'output.txt').read_text()
    assert 'no gyro' in said and 'http://localhost:' in said and usual not in said, said


@pytest.mark.parametrize('words, line', [
    (['heading', 'no_such_package', 'node.py'], 'there is no package no_such_package'),
    (['heading', 'rotate_robot', 'no_such.py'], 'rotate_robot has no executable file'),
    (['heading', __file__, 'b.py'], 'b.py is a second file'),
    (['heading', 'odometry_launch', 'sim.launch'], 'sim.launch starts a robot, but there is one already'),
    (['heading', 'rotate_robot', 'rotate.py', '--csv', '/no/such/file'], '/no/such/file'),
    (['heading', '.', '--view'], '--view shows one node'),
    (['heading', 'x.py', '--scenario', 'route'], 'heading has no scenario route, but plain')])
def test_what_makes_no_sense_is_one_line(words, line):
    """And status 2, before anything runs."""
    ran = check(*words, status=2)
    assert line in ran.stderr.splitlines()[-1]
    assert not ran.stdout


def test_a_check_that_cannot_run_leaves_ci_no_suite_that_passed(tmp_path):
    junit = tmp_path / 'junit.xml'
    ran = check('heading', 'no_such.py', '--junit', junit, status=2)
    assert 'there is no file or folder no_such.py' in ran.stderr
    assert not junit.read_bytes()
