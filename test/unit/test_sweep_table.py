"""What a sweep says of its runs."""

import io

import pytest
from odometry_sweep import progress
from odometry_sweep.limits import broken
from odometry_sweep.picture import make_figure
from odometry_sweep.progress import Progress
from odometry_sweep.summary import Setting
from odometry_sweep.table import name_of, table

FIGURES = 'moved_error', 'true_error', 'sideways', 'heading', 'time'


def rows(errors, ended='arrived'):
    """Return runs with these figures, each the same in all."""
    return [{**dict.fromkeys(FIGURES, error), 'ended': ended} for error in errors]


def test_percentiles_and_the_worst_are_those_of_the_runs():
    """The worst is the farthest from zero; a size has no sign."""
    setting = Setting('all', rows([0.01 * number for number in range(-60, 41)]))
    assert setting.statistic('sideways', 'median') == pytest.approx(-0.10)
    assert setting.statistic('sideways', 'p5') == pytest.approx(-0.55)
    assert setting.statistic('sideways', 'p95') == pytest.approx(0.35)
    assert setting.statistic('sideways', 'worst') == pytest.approx(-0.60)
    assert setting.size('sideways', 'worst') == pytest.approx(0.60)
    assert setting.size('sideways', 'p95') == pytest.approx(0.55)


def test_a_table_has_a_block_for_each_figure_and_a_line_for_each_setting():
    """In columns, and zero has no sign."""
    settings = [Setting('kp 1', rows([0.25, 0.25])), Setting('kp 2', rows([-0.00001]))]
    assert table('move', settings).split('\n\n')[0] == (
        'moved_error (m)      median       5 %      95 %     worst\n'
        'kp 1                 0.2500    0.2500    0.2500    0.2500\n'
        'kp 2                 0.0000    0.0000    0.0000    0.0000')
    assert table('move', settings).count('kp 1') == len(FIGURES)


def test_a_setting_is_named_by_what_varies():
    """If anything does."""
    assert name_of(['a', 'b'], {'a': 1, 'b': 'x', 'c': 2}) == 'a 1, b x'
    assert name_of([], {'c': 2}) == 'all runs'


def test_runs_that_came_out_the_same_are_noticed():
    """A single one is no repetition."""
    assert Setting('', rows([0.1, 0.1])).all_equal
    assert not Setting('', rows([0.1, 0.2])).all_equal
    assert not Setting('', rows([0.1])).all_equal


@pytest.mark.parametrize('limits, lines', [
    ({'sideways_worst': 0.2}, []), ({'sideways_worst': 0.199}, [
        'sideways_worst is 0.2, over its limit of 0.199, with kp 1']),
    ({'sideways_median': 0.05, 'time_p5': 0.01}, [
        'sideways_median is 0.1, over its limit of 0.05, with kp 1',
        'time_p5 is 0.1, over its limit of 0.01, with kp 1']),
    ({'not_arrived': 3}, []), ({'not_arrived': 2}, ['not_arrived is 3, over its limit of 2, with kp 1'])])
def test_a_limit_is_for_the_size_of_a_figure(limits, lines):
    """At the limit is within it."""
    assert [*broken(limits, Setting('kp 1', rows([0.1, 0.1, -0.2], 'late')))] == lines


@pytest.fixture
def shown(monkeypatch):
    """Return a function that shows the progress of four runs, one in two seconds."""
    def show(live):
        clock, output = [100.0], io.StringIO()
        output.isatty = lambda: live
        monkeypatch.setattr(progress.time, 'monotonic', lambda: clock[0])
        monkeypatch.setattr('sys.stdout', output)
        line = Progress(4)
        for _ in range(4):
            clock[0] += 2.0
            line.step()
        line.finish()
        monkeypatch.undo()
        return output.getvalue()

    return show


def test_on_a_terminal_one_line_is_rewritten(shown):
    """With the time that is left, as soon as it can be told; the last one stays."""
    lines = shown(True).split('\r\x1b[K')[1:]
    assert [line[33:] for line in lines] == [
        '1 of 4 runs', '2 of 4 runs, 0.5 a second, 0:00:04 left',
        '3 of 4 runs, 0.5 a second, 0:00:02 left', '4 of 4 runs, 0.5 a second, 0:00:00 left',
        '4 of 4 runs, 0.5 a second, 0:00:00 left\n']


def test_elsewhere_there_is_a_line_every_few_seconds(shown):
    """Without control characters, and the end."""
    assert [line[33:] for line in shown(False).splitlines()] == [
        '4 of 4 runs, 0.5 a second, 0:00:00 left'] * 2


def test_the_picture_has_a_diagram_for_each_figure_and_a_line_for_each_setting():
    """Also where all runs are the same."""
    settings = [Setting('kp 1', rows([0.25, 0.25])), Setting('kp 2', rows([0.1, 0.2, 0.3]))]
    figure = make_figure('move', settings)
    assert [axes.get_title() for axes in figure.axes] == [*FIGURES]
    assert [label.get_text() for label in figure.axes[0].get_yticklabels()] == ['kp 1', 'kp 2']
    medians = [line.get_xdata()[0] for line in figure.axes[0].get_lines() if line.get_color() == 'black']
    assert medians == [0.25, 0.2]
