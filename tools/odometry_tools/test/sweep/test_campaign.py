"""A sweep's command line and campaign files."""

import pytest
import yaml
from odometry_common.parameters import StartError
from odometry_tools.sweep.campaign import Campaign, read_campaign
from odometry_tools.sweep.options import parse
from odometry_tools.sweep.subjects import Tutorial


@pytest.fixture
def written(tmp_path):
    def write(content):
        path = tmp_path / 'campaign.yaml'
        path.write_text(content if isinstance(content, str) else yaml.safe_dump(content))
        return path
    return write


def test_the_command_line_and_a_file_say_the_same(written):
    """In a file a single value needs no list; the file that a sweep leaves can be run again."""
    values = {'wheel_slip': [0, '1e-2'], 'gyro': [True], 'odometry_source': ['encoder']}
    campaign = parse(['move', '--seeds', '3', '--set', 'wheel_slip=0,1e-2', '--set', 'gyro=true',
                      '--set', 'odometry_source=encoder']).campaign
    assert campaign == Campaign(Tutorial('move'), 3, values, {})
    file = written({'tutorial': 'move', 'seeds': 3, 'set': {**values, 'gyro': True},
                    'limits': {'sideways_p95': 0.5}})
    campaign = campaign._replace(limits={'sideways_p95': 0.5})
    assert parse(['--campaign', str(file)]).campaign == campaign
    campaign.checked()


def test_a_number_may_have_an_exponent(written):
    """YAML reads 1e-2 as a string."""
    numbers = {'seeds': '1e1', 'limits': {'sideways_p95': '1e-2'}}
    campaign = read_campaign(written({'tutorial': 'move', **numbers})).checked()
    assert (campaign.seeds, campaign.limits) == (10, {'sideways_p95': 0.01})


@pytest.mark.parametrize('arguments, line', [
    ([], 'choose a tutorial, move or rotate'),
    (['move', '--jobs', '1', '--cluster', 'tcp://host:1'], 'not allowed with argument --jobs'),
    (['guest', 'a.launch', '--set', 'max-speed=1'], 'argument --until: a launch file needs it'),
    (['move', '--set', 'speed'], 'is not NAME=VALUE,VALUE,...'), (['move', '--set', 'speed='], 'is not NAME=VALUE,VALUE,...'),
    (['move', '--set', f'speed={"[" * 1000}'], "[[' contains a value that is not YAML"),
    (['move', '--set', 'speed=1', '--set', 'speed=2'], 'a parameter is set twice'),
    (['move', '--campaign', 'x.yaml'], 'the file of --campaign or --replay sets tutorial, --seeds')])
def test_an_option_that_makes_no_sense_gets_one_line(capsys, arguments, line):
    with pytest.raises(SystemExit) as end:
        parse(arguments)
    assert end.value.code == 2
    assert line in capsys.readouterr().err.splitlines()[-1]


@pytest.mark.parametrize('content, line', [
    ('[' * 1000, 'cannot be read: '), ('3', 'names no tutorial'),
    ('seeds: 3', 'there is no tutorial None: there is move, rotate'),
    ({'launch': 'move', 'until': 1}, "launch is 'move', but must be [package, file]"),
    ({'tutorial': 'move', 'until': 1}, "has 'until': there is limits, seeds, set, tutorial"),
    ({'tutorial': 'move', 'seed': 3}, "has 'seed': did you mean seeds?"),
    ({'tutorial': 'move', 'seeds': True}, 'seeds is True, but must be a whole number from 1'),
    ({'tutorial': 'move', 'set': {'speed': []}}, 'there are 0 runs, but must be 1 to 1000000'),
    ({'tutorial': 'move', 'set': {'kp': 1}},
     'parameter kp cannot be set in a sweep of move: there is cmd_vel_timeout, dist'),
    ({'tutorial': 'move', 'limits': {'overshoot_p95': 1}}, 'unknown limit overshoot_p95: there is '),
    ({'tutorial': 'move', 'limits': {'time_p5': -1}}, 'limit time_p5 is -1, but must be a number from 0')])
def test_a_file_that_makes_no_sense_gets_one_line(written, content, line):
    with pytest.raises(StartError) as refusal:
        read_campaign(written(content)).checked()
    assert line in str(refusal.value)
    assert len(str(refusal.value).splitlines()) == 1


def test_a_world_is_found_from_where_the_user_stands(written, monkeypatch, tmp_path):
    """Also by nodes and a replay, which run elsewhere."""
    monkeypatch.chdir(tmp_path)
    expected = ['', str(tmp_path / 'my.urdf')]
    for arguments in ['move', '--set', "world='',my.urdf"], \
            ['--campaign', str(written({'tutorial': 'move', 'set': {'world': ['', 'my.urdf']}}))]:
        assert parse(arguments).campaign.values == {'world': expected}
