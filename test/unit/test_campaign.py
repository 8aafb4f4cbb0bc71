"""What a sweep is told, by its command line or by a file."""

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st
from odometry_common.parameters import StartError
from odometry_sweep.campaign import Campaign, read_campaign
from odometry_sweep.options import parse

values = st.lists(st.one_of(st.integers(-5, 5), st.floats(0, 1)), min_size=1, max_size=3)
GRID, HUNDRED = ['speed', 'distance', 'x', 'y', 'yaw'], [step / 100 for step in range(1, 101)]
grids = st.dictionaries(st.sampled_from(['kp', 'target', 'x', 'wheel_slip']), values)


def write(folder, content):
    """Write a campaign file and return its path."""
    path = folder / 'campaign.yaml'
    path.write_text(content if isinstance(content, str) else yaml.safe_dump(content))
    return path


@given(grids, st.integers(1, 4))
def test_every_combination_is_run_with_every_seed_once(grid, seeds):
    """In the same order each time: the row's number says which run it was."""
    runs = list(Campaign('rotate', seeds, grid, {}).runs())
    assert len(runs) == Campaign('rotate', seeds, grid, {}).count
    expected = seeds
    for some in grid.values():
        expected *= len(some)
    assert len(runs) == expected
    for name, some in grid.items():
        for value in some:
            share = expected * some.count(value) // len(some)
            assert sum(run[name] == value for run in runs) == share
    assert [run['seed'] for run in runs] == [*range(seeds)] * (expected // seeds)


def test_the_command_line_says_what_to_run():
    """Values are of the kind that they look like."""
    campaign = parse(['move', '--seeds', '3', '--set', 'wheel_slip=0,1e-2', '--set', 'gyro=true',
                      '--set', 'odometry_source=encoder']).campaign
    assert campaign == Campaign('move', 3, {
        'wheel_slip': [0, '1e-2'], 'gyro': [True], 'odometry_source': ['encoder']}, {})
    campaign.check()


def test_a_file_says_the_same(tmp_path):
    """A single value needs no list; what a sweep leaves behind can be run again."""
    campaign = read_campaign(write(tmp_path, {
        'tutorial': 'rotate', 'seeds': 2, 'set': {'target': [90, -45.5], 'kp': 1},
        'limits': {'overshoot_p95': 0.5}}))
    assert campaign == Campaign('rotate', 2, {'target': [90, -45.5], 'kp': [1]},
                                {'overshoot_p95': 0.5})
    campaign.check()
    assert read_campaign(write(tmp_path, campaign.text())) == campaign


@pytest.mark.parametrize('arguments, line', [
    ([], 'say which tutorial'),
    (['dance'], "invalid choice: 'dance'"),
    (['move', '--seeds', '0'], "'0' is not a whole number from 1"),
    (['move', '--seeds', '1.5'], "'1.5' is not a whole number from 1"),
    (['move', '--jobs', 'all'], "'all' is not a whole number from 1"),
    (['move', '--set', 'speed'], "'speed' is not NAME=VALUE,VALUE,..."),
    (['move', '--set', '=1'], "'=1' is not NAME=VALUE,VALUE,..."),
    (['move', '--set', 'speed=[1'], "'speed=[1' has a value that is no YAML"),
    (['move', '--set', f'speed={"[" * 5000}'], "[[' has a value that is no YAML"),
    (['move', '--set', 'speed=1', '--set', 'speed=2'], 'a parameter is set twice'),
    (['move', '--campaign', 'x.yaml'], 'the file says all of tutorial, --seeds and --set')])
def test_an_option_that_makes_no_sense_gets_one_line(capsys, arguments, line):
    """And exit status 2."""
    with pytest.raises(SystemExit) as end:
        parse(arguments)
    assert end.value.code == 2
    assert line in capsys.readouterr().err.splitlines()[-1]


@pytest.mark.parametrize('content, line', [
    ('{', 'is no YAML'), ('', 'names no tutorial'), ('[move]', 'names no tutorial'),
    ('seeds: 3', 'names no tutorial'), ('\0', 'is no YAML'), ('[' * 5000, 'is no YAML'),
    ({'tutorial': 'dance'}, "the tutorial is 'dance', but must be move or rotate"),
    ({'tutorial': ['move']}, "the tutorial is ['move'], but must be move or rotate"),
    ({'tutorial': 'move', 'seed': 3}, "has 'seed', but may have tutorial, seeds, set, limits"),
    ({'tutorial': 'move', 'seeds': 0}, 'seeds is 0, but must be a whole number from 1'),
    ({'tutorial': 'move', 'seeds': True}, 'seeds is True, but must be'),
    ({'tutorial': 'move', 'set': [1]}, 'set is [1], but must have a line for each name'),
    ({'tutorial': 'move', 'set': {'speed': []}}, 'speed has no value'),
    ({'tutorial': 'move', 'set': {'speed': [0.1, 0]}},
     'parameter ~speed is 0, but must be a number other than 0 m/s'),
    ({'tutorial': 'move', 'set': dict.fromkeys(GRID, HUNDRED)},
     'there are 10000000000 runs, but must be 1000000 at most'),
    ({'tutorial': 'move', 'set': {'speed': [[1]]}}, 'parameter ~speed is [1], but must be'),
    ({'tutorial': 'move', 'set': {'wheel_slip': 'nan'}}, "parameter ~wheel_slip is 'nan', but"),
    ({'tutorial': 'move', 'set': {'kp': 1}}, 'unknown parameter kp; move has cmd_vel_timeout, dist'),
    ({'tutorial': 'move', 'set': {3: 1}}, 'unknown parameter 3; move has'),
    ({'tutorial': 'rotate', 'set': {'speed': 1}}, 'unknown parameter speed; rotate has'),
    ({'tutorial': 'move', 'set': {'seed': 1}}, 'parameter seed is set for each run'),
    ({'tutorial': 'move', 'set': {'gui': True}}, 'parameter gui means nothing in a run without ROS'),
    ({'tutorial': 'rotate', 'set': {'tolerance': 1}}, 'parameter tolerance means nothing'),
    ({'tutorial': 'rotate', 'set': {'rate': 15}},
     'parameter ~rate is 15.0, but must be ~odom_rate, 20 Hz, divided by a whole number'),
    ({'tutorial': 'rotate', 'set': {'rate': 40}}, 'parameter ~rate is 40.0, but must be'),
    ({'tutorial': 'move', 'set': {'world': '/no/such.urdf'}}, "parameter ~world is '/no/such.urdf'"),
    ({'tutorial': 'move', 'limits': {'moved_error': 1}}, 'unknown limit moved_error; it is'),
    ({'tutorial': 'move', 'limits': {'overshoot_p95': 1}}, 'unknown limit overshoot_p95; it is'),
    ({'tutorial': 'move', 'limits': {'moved_error_p95': -1}},
     'limit moved_error_p95 is -1, but must be a number from 0'),
    ({'tutorial': 'move', 'limits': {'moved_error_p95': 'x'}}, 'limit moved_error_p95 is'),
    ({'tutorial': 'move', 'limits': {'moved_error_p95': float('nan')}}, 'limit moved_error_p95 is')])
def test_a_file_that_makes_no_sense_gets_one_line(tmp_path, content, line):
    """The nodes' own, where a node would refuse a value."""
    with pytest.raises(StartError) as refusal:
        read_campaign(write(tmp_path, content)).check()
    assert line in str(refusal.value)
    assert len(str(refusal.value).splitlines()) == 1


def test_a_file_that_is_not_there_gets_one_line(tmp_path):
    """Which names it."""
    with pytest.raises(StartError, match='none.yaml cannot be read'):
        read_campaign(tmp_path / 'none.yaml')


@pytest.mark.parametrize('rate, odom_rate', [(20, 20), (10, 20), (5, 20), (0.5, 20), (0.7, 2.1), (50, 50)])
def test_a_controller_that_keeps_step_with_the_odometry_is_run(rate, odom_rate):
    """Every odometry, or each that many."""
    Campaign('rotate', 1, {'rate': [rate], 'odom_rate': [odom_rate]}, {}).check()
