"""What a sweep starts, shows, keeps and draws, without physics."""

import pytest
from odometry_tools.sweep.campaign import Campaign
from odometry_tools.sweep.main import with_progress
from odometry_tools.sweep.picture import make_figure
from odometry_tools.sweep.results import METRICS, SHOWN, Combination, table, write_results
from odometry_tools.sweep.subjects import Tutorial


def rows(values, ended='arrived'):
    return [{**dict.fromkeys(METRICS['move'], value), 'ended': ended} for value in values]


def test_a_table_has_a_block_for_each_metric_and_a_line_for_each_combination():
    """The worst is the farthest from zero, and zero has no sign."""
    settings = [Combination('kp 1', rows([0.01 * number for number in range(-60, 41)])),
                Combination('kp 2', rows([-0.00001]))]
    assert table('move', settings).split('\n\n')[0] == (
        'moved_error (m)      median       5 %      95 %     worst\n'
        'kp 1                -0.1000   -0.5500    0.3500   -0.6000\n'
        'kp 2                 0.0000    0.0000    0.0000    0.0000')
    assert table('move', settings).count('kp 1') == len(SHOWN['move'])


@pytest.mark.parametrize('limit, figure, size, run', [
    ('sideways_worst', '|sideways|_worst', 0.2, 2), ('time_p5', '|time|_p5', 0.1, 2), ('not_arrived', 'not_arrived', 3, 0)])
def test_a_limit_is_for_the_size_of_a_metric(limit, figure, size, run):
    assert Combination('kp 1', rows([0.1, 0.1, -0.2], 'late')).size_of(limit) == (figure, pytest.approx(size), run)


def test_the_picture_has_a_diagram_for_each_metric_and_a_line_for_each_combination():
    settings = [Combination('kp 1', rows([0.25, 0.25])), Combination('map $_{$', rows([0.1, 0.2, 0.3]))]
    figure = make_figure(Tutorial('move'), settings)
    assert len(figure.axes) == len(SHOWN['move'])
    assert [label.get_text() for label in figure.axes[0].get_yticklabels()] == ['kp 1', 'map $_{$']
    figure.draw_without_rendering()
    runs, medians = (line.get_xdata() for line in figure.axes[0].get_lines())
    assert [*runs] == [0.25, 0.25, 0.1, 0.2, 0.3] and [*medians] == [0.25, 0.2]


def test_a_full_disk_is_named_by_the_file_that_is_on_it(tmp_path):
    (tmp_path / 'runs.csv').symlink_to('/dev/full')
    with pytest.raises(OSError, match=f'No space left on device: .{tmp_path}/runs.csv'):
        next(write_results(tmp_path, Campaign(Tutorial('move'), 1, {}, {}), []))


def test_a_sweep_gives_a_sign_of_life_before_its_first_run_is_done(monkeypatch, capsys):
    """A single run may take minutes."""
    monkeypatch.setattr('odometry_tools.sweep.main.LINE_PERIOD', 0.0)
    assert [*with_progress([None, 1, None, 2], 2)] == [1, 2]
    assert capsys.readouterr().out.splitlines()[0].endswith('] 0 of 2 runs')
