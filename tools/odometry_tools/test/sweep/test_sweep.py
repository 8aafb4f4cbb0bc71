"""./ws sweep as a user types it: rows, a table, and one line for what makes no sense."""

import os
import re
from xml.etree import ElementTree

import psutil
import pytest
from odometry_tests.processes import Process
from odometry_tests.scripts import ROOT
from odometry_tests.terminal import Terminal
from sweeps import TIMEOUT, WS, folder_of, rows_in, sweep

WITHOUT_AVX = 'glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2,-AVX'  # what ./ws switches off, and more
NOISY = ['move', '--seeds', '3', '--set', 'distance=1', '--set', 'speed=0.5,0.3',
         '--set', 'odometry_source=encoder', '--set', 'wheel_noise=0.01']
MANY = ['move', '--seeds', '100000', '--set', 'distance=0.1', '--jobs', '2']


def test_a_sweep_leaves_a_row_for_each_run_and_prints_a_table(monkeypatch):
    """And its campaign file gives the same rows again, to the last byte, on an older processor, too."""
    monkeypatch.setenv('MPLBACKEND', 'module://matplotlib_inline.backend_inline')
    first = sweep(*NOISY)
    assert first.stderr == '', first.output
    folder = folder_of(first.stdout)
    rows = rows_in(folder)
    assert [(row['run'], row['speed'], row['seed']) for row in rows] == [
        (str(number + 1), speed, str(number % 3))
        for number, speed in enumerate(['0.5'] * 3 + ['0.3'] * 3)]
    assert all(float(row['moved']) >= 1 and row['ended'] == 'arrived' for row in rows)
    assert len({row['moved'] for row in rows}) == 6, 'the noise is always the same'
    assert re.search(r'^true_error \(m\) +median +5 % +95 % +worst\nspeed 0.5 +-?0\.', first.stdout,
                     re.MULTILINE)
    assert ' 6 of 6 runs' in first.stdout
    assert (folder / 'distributions.png').read_bytes().startswith(b'\x89PNG')
    monkeypatch.setenv('GLIBC_TUNABLES', WITHOUT_AVX)
    second = sweep('--campaign', folder / 'campaign.yaml', '--jobs', '1')
    assert rows_in(folder_of(second.stdout)) == rows


def test_a_limit_that_does_not_hold_is_one_line_and_status_1_and_its_worst_run(tmp_path):
    file, report = tmp_path / 'limits.yaml', tmp_path / 'junit.xml'
    file.write_text('tutorial: move\nseeds: 2\nset: {distance: 0.1, speed: [0.2, 0.3]}\n'
                    'limits: {moved_error_p95: 0.001, not_arrived: 0}\n')
    run = sweep('--campaign', file, '--junit', report, status=1)
    _, line = run.stderr.splitlines()
    assert re.fullmatch(r'sweep: \|moved_error\|_p95 is .*, over its limit of 0.001, with speed 0.3', line), line
    assert re.fullmatch(r'(?s).*\nrun [34] .*\nthe same, to the last bit', run.stdout), run.output
    picture = ROOT / re.findall('^picture +(.*)$', run.stdout, re.MULTILINE)[-1]
    assert picture.exists() and picture.with_name('run.bag').exists()
    failed, held = ElementTree.parse(report).iter('testcase')
    assert failed.find('failure').get('message').endswith(line[len('sweep: '):]), line
    assert held.get('name') == 'not_arrived' and held.find('failure') is None


def test_ctrl_c_keeps_what_is_done():
    with Terminal(ROOT, {**os.environ, 'TERM': 'xterm'}) as terminal:
        terminal.type(' '.join(['./ws sweep', *MANY]))
        terminal.wait_for_output(' of 100000 runs, ', TIMEOUT)
        terminal.press_ctrl_c()
        assert terminal.wait_for_prompt(TIMEOUT) == 130, terminal.output
        assert 'moved_error (m)      median' in terminal.output, terminal.output
        found = re.search(r'sweep: interrupted after (\d+) of 100000 runs', terminal.output)
        assert found and 'Traceback' not in terminal.output, terminal.output
        rows = rows_in(folder_of(terminal.output))
    assert [row['run'] for row in rows] == [str(number + 1) for number in range(int(found[1]))]
    assert rows and all(row['ended'] == 'arrived' for row in rows)


@pytest.mark.nightly
def test_a_process_that_is_killed_ends_the_sweep_with_one_line():
    """As the system does when memory is short; what is done is kept.

    Whichever it is: no helper stands beside those that do runs, which would print tracebacks.
    """
    with Process(*WS, *MANY) as run:
        run.wait_for_output(' of 100000 runs, ', TIMEOUT)
        next(process for process in psutil.Process(run.pid).children(recursive=True)
             if not process.children()).kill()
        assert run.wait(TIMEOUT) == 1, run.output
    found = re.fullmatch(r'sweep: a process that did runs was killed after (\d+) of 100000 runs, '
                         r'which are in \S+', run.stderr)
    assert found, run.stderr
    assert len(rows_in(folder_of(run.stderr))) == int(found[1]) > 0
