"""What a sweep starts, shows, keeps and draws, without physics."""

import pytest
from odometry_sweep.campaign import Campaign
from odometry_sweep.main import with_progress
from odometry_sweep.picture import make_figure
from odometry_sweep.results import METRICS, SHOWN, Combination, read_rows, table, write_results


def rows(values, ended='arrived'):
    return [{**dict.fromkeys(METRICS['move'], value), 'ended': ended} for value in values]


def test_before_the_first_run_there_are_no_rows(tmp_path):
    assert read_rows(tmp_path) == []


def test_a_table_has_a_block_for_each_metric_and_a_line_for_each_combination():
    """The worst is the farthest from zero, and zero has no sign."""
    settings = [Combination('kp 1', rows([0.01 * number for number in range(-60, 41)])),
                Combination('kp 2', rows([-0.00001]))]
    assert table('move', settings).split('\n\n')[0] == (
        'moved_error (m)      median       5 %      95 %     worst\n'
        'kp 1                -0.1000   -0.5500    0.3500   -0.6000\n'
        'kp 2                 0.0000    0.0000    0.0000    0.0000')
    assert table('move', settings).count('kp 1') == len(SHOWN['move'])


@pytest.mark.parametrize('limits, lines', [
    ({'sideways_worst': 0.2, 'not_arrived': 3}, []),
    ({'sideways_median': 0.05, 'time_p5': 0.01, 'not_arrived': 2}, [
        'sideways_median is 0.1, over its limit of 0.05, with kp 1',
        'time_p5 is 0.1, over its limit of 0.01, with kp 1',
        'not_arrived is 3, over its limit of 2, with kp 1'])])
def test_a_limit_is_for_the_size_of_a_metric(limits, lines):
    assert [exceeded.line for exceeded in
            Combination('kp 1', rows([0.1, 0.1, -0.2], 'late')).exceeded(limits)] == lines


def test_the_picture_has_a_diagram_for_each_metric_that_varies_and_a_line_for_each_combination():
    settings = [Combination('kp 1', rows([0.25, 0.25])), Combination('kp 2', rows([0.1, 0.2, 0.3]))]
    figure = make_figure('move', settings)
    assert [axes.get_title().partition(' (')[0].replace(' ', '_') for axes in figure.axes] == [*SHOWN['move']]
    assert [label.get_text() for label in figure.axes[0].get_yticklabels()] == ['kp 1', 'kp 2']
    medians = [line.get_xdata()[0] for line in figure.axes[0].get_lines()
               if line.get_label() == 'median']
    assert medians == [0.25, 0.2]
    constant = make_figure('move', [Combination('kp 1', rows([0.25, 0.25]))])
    assert len(constant.axes) == 1, 'nothing varies; an empty picture would be no better'


def test_values_on_a_grid_fall_evenly_into_the_bins_of_the_picture():
    """Else some bins hold one step of the grid, and others two, which looks like a pattern of the robot."""
    times = [19.45 + 0.05 * step for step in range(21)]
    figure = make_figure('move', [Combination('kp 1', rows(times))])
    heights, *_ = figure.axes[0].patches[0].get_data()
    assert len({height for height in heights.round(6) if height}) == 1, heights


def test_a_full_disk_is_named_by_the_file_that_is_on_it(tmp_path):
    (tmp_path / 'runs.csv').symlink_to('/dev/full')
    with pytest.raises(OSError, match=f'No space left on device: .{tmp_path}/runs.csv'):
        next(write_results(tmp_path, Campaign('move', 1, {}, {}), []))


def test_a_sweep_gives_a_sign_of_life_before_its_first_run_is_done(monkeypatch, capsys):
    """A single run may take minutes."""
    monkeypatch.setattr('odometry_sweep.main.LINE_PERIOD', 0.0)
    assert [*with_progress([None, 1, None, 2], 2)] == [1, 2]
    assert capsys.readouterr().out.splitlines()[0].endswith('] 0 of 2 runs after 0:00:00')
