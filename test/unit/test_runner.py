"""What runs the tests tells the truth about them."""

import subprocess
import sys
import time

import pytest
from odometry_tests.processes import ATTEMPTS, GAVE_UP
from odometry_tests.scripts import ROOT, load_script

suite = load_script('test/runner/suite.py')
results = load_script('test/runner/results.py')
running = load_script('test/runner/running.py')
JUNIT = """<testsuite>
  <testcase classname="system.test_a" name="good" time="1"/>
  <testcase classname="system.test_a" name="bad" time="1"><failure>it said no</failure></testcase>
  <testcase classname="system.test_b.TestCase" name="left" time="1"><skipped message="no X"/></testcase>
</testsuite>"""


@pytest.fixture(autouse=True)
def results_of_its_own(tmp_path, monkeypatch):
    """Have the results of a test's jobs in a folder of its own."""
    monkeypatch.setattr(suite, 'RESULTS', tmp_path)


def python(name, code, **options):
    """Return a job of a line of Python."""
    return suite.Job(name, [sys.executable, '-c', code], **options)


def counts_of(cases):
    """Return the sums over cases."""
    return sum((case.counts for case in cases), results.Counts())


def test_each_test_counts_in_its_file():
    """One passed, one failed with its words, one skipped with its reason."""
    job = python('some', '')
    job.results.mkdir()
    (job.results / 'pytest.xml').write_text(JUNIT)
    good, bad, left = results.read_cases(job, 1, '', 3.0)
    assert [case.file for case in (good, bad, left)] == ['test_a', 'test_a', 'test_b']
    assert bad.failure == 'it said no' and left.skipped == 'no X'
    assert counts_of([good, bad, left]) == (1, 1, 1)


@pytest.mark.parametrize('status', [0, 1, -9])
def test_a_job_without_results_has_failed(status):
    """It ended before its first test, whatever its exit status; what it printed is told."""
    case, = results.read_cases(python('some', ''), status, 'Segmentation fault', 1.0)
    assert case.counts == (0, 1, 0)
    assert 'Segmentation fault' in case.failure and str(status) in case.failure


def test_an_exit_status_that_no_test_explains_is_a_failure():
    """Such as an error after the last test."""
    job = python('some', '')
    job.results.mkdir()
    (job.results / 'pytest.xml').write_text(JUNIT.replace('failure', 'system-out'))
    cases = results.read_cases(job, 3, 'crash at exit', 1.0)
    assert counts_of(cases) == (2, 1, 1)


@pytest.mark.parametrize('status, counts', [(0, (1, 0, 0)), (1, (0, 1, 0))])
def test_a_linter_is_one_test(status, counts):
    """Passed if it exits with 0."""
    cases = results.read_cases(python('lint', '', is_linter=True), status, 'finding', 1.0)
    assert counts_of(cases) == counts


@pytest.mark.parametrize('processors', [1, 2])
def test_jobs_run_side_by_side_but_what_draws_has_a_processor_to_itself(tmp_path, processors):
    """It waits for all others."""
    drawing, others = [[f'{kind}{number}' for number in range(7)] for kind in ('drawing', 'other')]
    jobs = [*(python(name, 'print(1)', draws=True) for name in drawing),
            *(python(name, 'print(1)') for name in others)]
    seen = []
    ended = [one.job.name for one in running.run(
        jobs, processors, tmp_path, lambda some: seen.append({one.job.name for one in some}))]
    assert sorted(ended[:7]) == others and sorted(ended[7:]) == drawing
    assert max(len(names) for names in seen if names <= {*others}) == 3 * processors
    assert max(len(names) for names in seen if names <= {*drawing}) == processors
    assert all(names <= {*others} or names <= {*drawing} for names in seen)


def test_a_command_that_is_not_there_has_failed(tmp_path):
    """Whatever the reason, the others go on."""
    job = suite.Job('lint', ['no_such_linter'], is_linter=True)
    ended, = running.run([job], 1, tmp_path, lambda _: None)
    case, = results.read_cases(job, ended.status, ended.output, ended.seconds)
    assert case.counts == (0, 1, 0) and 'no_such_linter' in case.failure


@pytest.mark.parametrize('late, printed', [(1, 'ok'), (100, GAVE_UP)])
def test_who_gives_up_its_master_is_run_again(tmp_path, late, printed):
    """As roslaunch does after ten seconds, however busy the machine is; but not for ever."""
    code = ("with open('../runs', 'a') as runs:\n    runs.write('.')\n    number = runs.tell()\n"
            f"print('{GAVE_UP}' if number <= {late} else 'ok')")
    ended, = running.run([python('late', code, starts_master=True)], 1, tmp_path, lambda _: None)
    assert ended.output.strip() == printed
    assert len((tmp_path / 'runs').read_text()) == min(late + 1, ATTEMPTS)


def test_an_interrupted_run_leaves_no_process(tmp_path):
    """Ctrl-C while a job runs: it is interrupted, and has ended when the run has."""
    job = python('long', 'import time\nprint("up", flush=True)\ntime.sleep(600)')
    started = []

    def press_ctrl_c(some):
        started[:] = some
        if 'up' in some[0].output:
            raise KeyboardInterrupt

    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        list(running.run([job], 1, tmp_path, press_ctrl_c))
    assert started[0].status is not None
    assert 'KeyboardInterrupt' in started[0].output
    assert time.monotonic() - begin < 600


def test_all_jobs_are_interrupted_before_any_is_waited_for(tmp_path):
    """Each of these two ends only if the other one has been interrupted, too."""
    code = ("import pathlib, sys, time\ntry:\n    print('up', flush=True)\n    time.sleep(600)\n"
            "except KeyboardInterrupt:\n    me, other = map(pathlib.Path, sys.argv[1:])\n"
            "    me.touch()\n    while not other.exists():\n        time.sleep(0.01)\n"
            "    print('both')")
    jobs = [suite.Job(me, [sys.executable, '-c', code, f'../{me}.end', f'../{other}.end'])
            for me, other in ('ab', 'ba')]
    started = []

    def press_ctrl_c(some):
        started[:] = some
        if all('up' in one.output for one in some):
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        list(running.run(jobs, 2, tmp_path, press_ctrl_c))
    assert [one.output.split() for one in started] == [['up', 'both']] * 2


@pytest.mark.parametrize('name', ['report', 'test_nothing', 'run_soak', ''])
def test_a_name_of_no_test_is_refused(name):
    """In one line, also if there is another file of that name."""
    with pytest.raises(suite.argparse.ArgumentTypeError, match='there is no test'):
        suite.job(name)


def test_every_test_file_is_run():
    """Each file of each folder is in a job, and has one of its own by name."""
    commands = [' '.join(map(str, job.command)) for job in suite.all_jobs()]
    assert any('/test/unit ' in command for command in commands)
    for file in [*suite.TESTS.glob('s*/test_*.py'), *suite.TESTS.glob('rostests/*.test')]:
        assert any(file.name in command for command in commands), file
        assert suite.job(file.stem if file.suffix == '.py' else file.name)


def test_bare_pytest_runs_the_unit_tests():
    """Not the node test_movement.py, nor what needs to be started in its own way."""
    collected = subprocess.run([sys.executable, '-m', 'pytest', '--collect-only', '-qq',
                                '-p', 'no:warnings'],
                               check=False, cwd=ROOT, capture_output=True, text=True)
    files = {line.rpartition(':')[0] for line in collected.stdout.splitlines() if line}
    assert files == {f'test/unit/{file.name}' for file in (ROOT / 'test/unit').glob('test_*.py')}, \
        collected.stdout + collected.stderr
