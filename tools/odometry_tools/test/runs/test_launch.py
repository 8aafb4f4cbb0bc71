"""The demo's command line; what a demo waits for, what its nodes print, where it records; its ports."""

import socket
import subprocess
import threading
import time

import pytest
import yaml
from odometry_tests.processes import Process
from odometry_tools.runs.folders import new_folder
from odometry_tools.runs.launch import Launch
from odometry_tools.runs.node_output import NodeOutput
from odometry_tools.runs.options import parse
from odometry_tools.runs.output import RunError
from odometry_tools.runs.ports import HeldPort, next_port, usual_master_port


@pytest.fixture
def launch(monkeypatch):
    monkeypatch.setattr(Launch, 'check', lambda self: None)
    return Launch('odometry_launch', 'sim.launch', {})


def test_an_unexpected_error_ends_a_wait_at_once(launch):
    def condition():
        raise AttributeError('no such thing')

    with pytest.raises(RunError, match='^no answer: AttributeError: no such thing$'):
        launch.wait_for(condition, 'no answer')


def test_a_master_that_is_suspended_ends_a_wait(launch, monkeypatch):
    monkeypatch.setattr('odometry_tools.runs.launch.START_TIMEOUT', 0.1)
    with pytest.raises(RunError, match='^no answer within 0.1 s; '):
        launch.wait_for(threading.Event().wait, 'no answer')


def test_the_complaint_of_a_node_is_its_last_line_that_begins_with_its_name(capfd):
    output = NodeOutput()
    with output.capture():
        subprocess.run(['printf', 'view: one\n\nview: two\nother: three\nview\n'], check=True)
    subprocess.run(['echo', 'view: four'], check=True)
    assert (output.complaint_of('view'), output.complaint_of('rotate_robot')) == ('view: two', None)
    output.add('view')
    assert output.last_lines().endswith('\nother: three\nview\nview')
    assert capfd.readouterr().out == 'view: four\n'


def test_demos_of_the_same_second_have_a_folder_each(tmp_path, monkeypatch):
    monkeypatch.setattr(time, 'strftime', lambda _: 'now')
    monkeypatch.setattr('odometry_tools.runs.folders.RUNS', tmp_path / 'runs')
    folders = [new_folder() for _ in range(3)]
    assert [folder.name for folder in folders] == ['now', 'now_2', 'now_3']


@pytest.mark.parametrize('arguments', [
    ['--speed', '0'], ['--distance', '-1'], ['--distance', 'far'],
    ['--real-time-factor', 'fast'], ['--target', '45'],
    ['rotate', '--speed', '-0.1'], ['dance']])
def test_bad_options_get_one_clear_line(arguments, capsys):
    with pytest.raises(SystemExit) as ending:
        parse(arguments)
    assert ending.value.code == 2
    assert capsys.readouterr().err.splitlines()[-1].startswith('./ws demo: error: argument')


def test_an_unknown_option_is_named_and_not_its_value(capsys):
    with pytest.raises(SystemExit):
        parse(['--distnce', '3'])
    assert 'unrecognized arguments: --distnce' in capsys.readouterr().err


def test_a_held_port_is_given_to_nobody_else():
    """But its server can listen on it; after close() it is free at once."""
    held = HeldPort(0)
    with pytest.raises(OSError):
        HeldPort(held.number)
    following = next_port(held.number)
    assert following.number > held.number
    following.close()
    socket.create_server(('localhost', held.number)).close()
    held.close()
    HeldPort(held.number).close()


@pytest.mark.parametrize('name', ['sim', 'move_two_meters', 'rotate'])
def test_a_file_sets_the_parameters_that_are_no_arguments(tmp_path, name):
    (tmp_path / 'drift.yaml').write_text('{gyro: false, gyro_drift: 0.01}')
    with Process('roslaunch', '--dump-params', 'odometry_launch', f'{name}.launch', 'params:=drift.yaml',
                 cwd=tmp_path) as dump:
        assert dump.wait() == 0, dump.output
    values = {key: value for key, value in yaml.safe_load(dump.stdout).items() if 'gyro' in key}
    assert values == {'/sim_turtlebot/gyro': False, '/sim_turtlebot/gyro_drift': 0.01,
                      '/sim_turtlebot/gyro_noise': 0.0, '/sim_turtlebot/gyro_scale_error': 0.0,
                      '/sim_turtlebot/gyro_scale_correction': 1.0}


@pytest.mark.parametrize('address, port', [
    ('http://localhost:1234', 1234), ('', 11311), ('localhost', 11311), ('[', 11311),
    ('http://localhost:none', 11311), ('http://localhost:123456', 11311)])
def test_the_master_goes_where_rostopic_looks_for_it(address, port, monkeypatch):
    monkeypatch.setenv('ROS_MASTER_URI', address)
    assert usual_master_port() == port
