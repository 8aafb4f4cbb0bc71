"""The demo's command line; what a demo waits for, where it records, where its master is."""

import os
import re
import signal
import threading
import time

import pytest
import yaml
from odometry_tests.processes import run
from odometry_tools.runs.folders import new_folder
from odometry_tools.runs.launch import Launch
from odometry_tools.runs.launch_files import load, path_of
from odometry_tools.runs.options import parse
from odometry_tools.runs.output import RunError
from odometry_tools.runs.ports import usual_master_port


def test_a_master_that_is_suspended_ends_a_wait(monkeypatch):
    """Also if the handler of a signal is not done when it looks again."""
    launch = Launch('odometry_launch', 'sim.launch', {})
    signal.signal(signal.SIGUSR1, lambda *_: time.sleep(0.2))
    threading.Timer(0.01, os.kill, [os.getpid(), signal.SIGUSR1]).start()
    monkeypatch.setattr(Launch, 'check', lambda self: None)
    monkeypatch.setattr('odometry_tools.runs.launch.START_TIMEOUT', 0.1)
    with pytest.raises(RunError, match='^no answer within 0.1 s; '):
        launch.wait_for(threading.Event().wait, 'no answer')


def test_a_real_time_signal_has_no_name():
    launch = Launch('odometry_launch', 'sim.launch', {})
    launch.process_died('node-1', -40)
    assert launch.end_of('node') == 'node has ended by a signal (Real-time signal 6)'


def test_demos_of_the_same_second_have_a_folder_each(tmp_path, monkeypatch):
    monkeypatch.setattr(time, 'strftime', lambda _: 'now')
    monkeypatch.setattr('odometry_tools.runs.folders.RUNS', tmp_path / 'runs')
    folders = [new_folder() for _ in range(3)]
    assert [folder.name for folder in folders] == ['now', 'now_2', 'now_3']


def test_a_folder_of_runs_that_cannot_be_made_is_an_error(tmp_path, monkeypatch):
    (tmp_path / 'disk').symlink_to('unmounted')
    monkeypatch.setattr('odometry_tools.runs.folders.RUNS', tmp_path / 'disk')
    with pytest.raises(FileExistsError):
        new_folder()


def test_all_nodes_of_a_launch_file_are_in_its_namespace(monkeypatch):
    monkeypatch.setenv('ROS_NAMESPACE', '/lab')
    config = load(path_of('odometry_launch', 'move_two_meters.launch'), [])
    assert {node.namespace for node in config.nodes} == {'/lab/'}


@pytest.mark.parametrize('arguments', [
    ['--speed', '0'], ['--distance', 'far'], ['--target', '45'], ['rotate', '--speed', '-0.1'], ['dance'],
    ['--real-time-factor', '-1'], ['--distnce', '3']])
def test_bad_options_get_one_clear_line(arguments, capsys):
    with pytest.raises(SystemExit) as ending:
        parse(arguments)
    assert ending.value.code == 2
    line = capsys.readouterr().err.splitlines()[-1]
    assert re.match(r'./ws demo: error: (argument|unrecognized arguments: --distnce)', line), line


@pytest.mark.parametrize('name', ['sim', 'move_two_meters', 'rotate'])
def test_a_file_sets_the_parameters_that_are_no_arguments(tmp_path, name):
    (tmp_path / 'drift.yaml').write_text('{gyro: false, gyro_drift: 0.01}')
    dump = run('roslaunch', '--dump-params', 'odometry_launch', f'{name}.launch', 'params:=drift.yaml', cwd=tmp_path)
    values = yaml.safe_load(dump.stdout)
    assert [values[f'/sim_turtlebot/{key}'] for key in ('gyro', 'gyro_drift', 'gyro_noise')] == [False, 0.01, 0.0]


@pytest.mark.parametrize('address, port', [
    ('http://localhost:1234', 1234), ('', 11311), ('[', 11311), ('http://localhost:123456', 11311)])
def test_the_master_goes_where_rostopic_looks_for_it(address, port, monkeypatch):
    monkeypatch.setenv('ROS_MASTER_URI', address)
    assert usual_master_port() == port
