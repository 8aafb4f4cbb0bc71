"""What ./ws starts listens on loopback only, however the environment names that.

The same is looked at wherever another test has something running that ./ws has started: the demo
in test_demo_endings, with its page in test_demo_page, the bench in test_bench, the soak in
test_soak. That --host lets others in is seen in test_two_machines.
"""

import os

import pytest
from odometry_tests.listening import assert_loopback_only
from odometry_tests.processes import Process, hold_port, launched
from odometry_tests.scripts import ROOT
from odometry_tests.terminal import Terminal

SET_BY_WS = 'ROS_HOSTNAME', 'ROS_IP', 'ROS_ETC_DIR'
# Where the path of this project has a space, ROS knows it by another name.
ON_LOOPBACK = f'localhost\n{os.environ["ODOMETRY_ROOT"]}/launch/etc'
NETWORK = 'export ROS_HOSTNAME=0.0.0.0\n'


def in_clean_environment(*command):
    """Start a command without what the ./ws that runs this test has set."""
    return Process('env', *(f'--unset={name}' for name in SET_BY_WS), *command)


def test_a_launch_listens_on_loopback_only():
    """Master, rosout, nodes: nobody else on the network can drive the robot."""
    with hold_port() as port, launched(lambda: in_clean_environment(
            ROOT / 'ws', 'roslaunch', '-p', port, 'odometry_launch', 'move_two_meters.launch'),
            'driving at') as launch:
        assert_loopback_only(launch.pid)


@pytest.mark.parametrize('preset', ['ROS_IP=127.0.0.1', 'ROS_HOSTNAME=localhost'])
def test_roscore_in_a_shell_listens_on_loopback_only(preset, tmp_path):
    """Even if ~/.bashrc, which the shell reads, wishes otherwise."""
    environment = {'HOME': str(tmp_path), 'PATH': os.environ['PATH'], 'TERM': 'xterm'}
    with hold_port() as port, Terminal(ROOT, environment) as terminal:
        (tmp_path / '.bashrc').write_text(NETWORK)
        terminal.type(f'{preset} ./ws shell')
        terminal.wait_for_prompt()
        terminal.launch(f'roscore -p {port}', 'started core service')
        assert_loopback_only(terminal.pid)
        terminal.press_ctrl_c()
        terminal.wait_for_prompt()


@pytest.mark.parametrize('settings', [
    [], ['ROS_HOSTNAME=localhost'], ['ROS_HOSTNAME=LocalHost.localdomain'], ['ROS_IP=127.0.0.1'],
    ['ROS_HOSTNAME=ip6-localhost', 'ROS_IP=192.0.2.1'], ['ROS_HOSTNAME=', 'ROS_IP=127.0.1.1']])
def test_each_name_of_loopback_is_the_same(settings):
    """The first of them that says something decides, as for rospy."""
    show = in_clean_environment(*settings, ROOT / 'ws', 'printenv', *SET_BY_WS)
    show.wait()
    assert show.output.strip() == ON_LOOPBACK


@pytest.mark.parametrize('settings, options, name', [
    (['ROS_HOSTNAME=robot.example'], [], 'robot.example'), (['ROS_IP=192.0.2.1'], [], '192.0.2.1'),
    (['ROS_HOSTNAME=localhost'], ['--host', '192.0.2.1'], '192.0.2.1')])
def test_an_address_of_the_network_is_left_as_it_is(settings, options, name):
    """Whoever sets it, or asks for --host, wants others to get in."""
    show = in_clean_environment(*settings, ROOT / 'ws', *options, 'printenv', *SET_BY_WS[:2])
    show.wait()
    assert show.output.strip() == name
