"""The demo's command line: what is refused, in one line that names the option."""

import pytest
from odometry_launch.options import parse


@pytest.mark.parametrize('arguments', [
    ['--speed', '0'], ['--speed', '2'], ['--distance', '-1'], ['--distance', 'far'],
    ['--real-time-factor', 'nan'], ['--real-time-factor', '0.0001'], ['--target', '45'],
    ['rotate', '--target', 'north'], ['rotate', '--speed', '-1e-1'], ['dance']])
def test_bad_options_get_one_clear_line(arguments, capsys):
    """Exit status 2, and behind the usage one line about the argument."""
    with pytest.raises(SystemExit) as ending:
        parse(arguments)
    assert ending.value.code == 2
    assert capsys.readouterr().err.splitlines()[-1].startswith('./ws demo: error: argument')


@pytest.mark.parametrize('text', ['-0.1', '-1e-1', '-.1', '-10e-2'])
def test_a_negative_speed_may_be_written_in_any_way(text):
    """With a blank before it, too."""
    assert parse(['--speed', text]).speed == parse([f'--speed={text}']).speed == -0.1
