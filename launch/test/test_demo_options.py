"""The demo's command line."""

import pytest
from odometry_launch.options import launch_arguments, parse


@pytest.mark.parametrize('arguments', [
    ['--speed', '0'], ['--speed', '2'], ['--distance', '-1'], ['--distance', 'far'],
    ['--real-time-factor', 'nan'], ['--real-time-factor', '0.0001'], ['--target', '45'],
    ['rotate', '--speed', '-0.1'], ['dance']])
def test_bad_options_get_one_clear_line(arguments, capsys):
    with pytest.raises(SystemExit) as ending:
        parse(arguments)
    assert ending.value.code == 2
    assert capsys.readouterr().err.splitlines()[-1].startswith('./ws demo: error: argument')


@pytest.mark.parametrize('factor, lockstep', [('1', 'false'), ('0', 'true'), ('0.5', 'true')])
@pytest.mark.parametrize('tutorial', ['move', 'rotate'])
def test_at_each_pace_but_real_time_it_runs_in_lockstep(tutorial, factor, lockstep):
    options = parse([tutorial, '--real-time-factor', factor])
    assert launch_arguments(options)[1]['lockstep'] == lockstep
