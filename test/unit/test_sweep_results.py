"""How many processes a sweep starts, and what it says that it has kept if it is interrupted."""

import csv
from types import SimpleNamespace

import pytest
from odometry_sweep import main, running
from odometry_sweep.campaign import Campaign
from odometry_sweep.figures import FIGURES

CAMPAIGN = Campaign('move', 9, {'distance': [0.1]}, {})


@pytest.fixture
def interrupted(tmp_path, monkeypatch, capsys):
    """Return a function that interrupts a sweep as it writes its third run; it returns the line."""
    def interrupt(written):
        class Interrupted(csv.DictWriter):
            def writerow(self, row):
                if row['run'] == 3:
                    if written:
                        super().writerow(row)
                    raise KeyboardInterrupt
                return super().writerow(row)

        def run_all(campaign):
            for parameters in campaign.runs():
                yield parameters, {**dict.fromkeys(FIGURES['move'], 0.1), 'ended': 'arrived'}

        monkeypatch.setattr(csv, 'DictWriter', Interrupted)
        monkeypatch.setattr(main, 'RUNS', tmp_path)
        with pytest.raises(KeyboardInterrupt):
            main._sweep(CAMPAIGN, run_all)
        return capsys.readouterr().err
    return interrupt


@pytest.mark.parametrize('written, count', [(False, 2), (True, 3)])
def test_ctrl_c_says_how_many_runs_are_in_the_file(interrupted, tmp_path, written, count):
    """Whether it comes before a run is in the file, or right after."""
    assert f'sweep: interrupted after {count} of 9 runs' in interrupted(written)
    file, = tmp_path.glob('sweep-*/runs.csv')
    assert len(file.read_text().splitlines()) == 1 + count


def test_ctrl_c_before_there_is_a_file_is_no_error(tmp_path, monkeypatch, capsys):
    """The first thing that is written is the campaign."""
    def interrupt(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(Campaign, 'text', interrupt)
    monkeypatch.setattr(main, 'RUNS', tmp_path)
    with pytest.raises(KeyboardInterrupt):
        main._sweep(CAMPAIGN, None)
    assert 'sweep: interrupted after 0 of 9 runs' in capsys.readouterr().err


@pytest.mark.parametrize('jobs, seeds, processes', [
    (None, 100, 4), (None, 3, 3), (6, 100, 6), (150, 1, 1), (99999, 10**6, 8)])
def test_there_are_never_more_processes_than_runs_or_than_twice_the_processors(
        monkeypatch, jobs, seeds, processes):
    """Of which there are four here."""
    started = []

    def parallel(n_jobs, **_):
        started.append(n_jobs)
        return lambda _: iter(())

    joblib = SimpleNamespace(cpu_count=lambda: 4, Parallel=parallel, delayed=None)
    monkeypatch.setattr(running, '_installed', lambda _: joblib)
    with running.side_by_side(jobs) as run_all:
        assert list(run_all(CAMPAIGN._replace(seeds=seeds))) == []
    assert started == [processes]
