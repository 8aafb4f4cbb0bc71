"""A process that a check starts can harm neither the check nor the machine."""

import sys
from pathlib import Path

import pytest
from kinematic_robot import PLAIN, TWO_METERS
from odometry_tests.waiting import wait_until
from odometry_tools.check import report
from odometry_tools.check.check_session import Pace
from odometry_tools.check.processes import LAST, ChildProcess
from odometry_tools.check.run import Run

PATIENCE = 60.0  # s


def ended(program):
    """Return a Python program, started and ended."""
    process = ChildProcess([sys.executable, '-c', program])
    assert process.wait(PATIENCE)
    return process


def test_of_a_flood_of_output_the_last_is_kept():
    output = ended(f'print("x" * {3 * LAST} + "end")').output
    assert output.endswith('xend\n')
    assert len(output) == LAST


@pytest.mark.parametrize('program, has_read', [('input()', True), ('import sys; sys.stdin.fileno()', False)])
def test_one_sees_whether_the_keyboard_was_read(program, has_read):
    assert ended(program).has_read_keyboard == has_read


def test_what_hides_in_another_session_is_found_and_ended():
    process = ChildProcess(['bash', '-c', 'setsid sleep 1000 & exit 3'])
    wait_until(lambda: process.status == 3, PATIENCE, 'the end of bash')
    assert not process.wait(0.0)
    process.end()
    assert not process.family()


def test_a_folder_that_cannot_be_written_leaves_the_verdict(monkeypatch, capsys):
    monkeypatch.setattr(report, 'RUNS', Path('/dev/null/runs'))
    assert report.keep(Run(PLAIN, Pace(), None), TWO_METERS, 'check-x') is None
    assert 'no recording: ' in capsys.readouterr().err
