"""What ./ws starts listens on loopback only, however the environment names that.

Other tests check the same of what they start: test_demo_endings, test_demo_page and
test_page_server.
"""

import os

import pytest
from odometry_tests.linux import assert_loopback_only
from odometry_tests.processes import Process, hold_port, run
from odometry_tests.scripts import ROOT
from odometry_tests.terminal import Terminal

SET_BY_WS = 'ROS_HOSTNAME', 'ROS_IP', 'ROS_ETC_DIR'
DASK_TIMEOUT = 60.0  # s
HERE = f'localhost\n{os.environ["ODOMETRY_ROOT"]}/tools/setup'  # a link where this project's path has a space


@pytest.mark.parametrize('settings, options, shown', [
    ('', '', HERE), ('ROS_HOSTNAME=LocalHost.localdomain', '', HERE), ('ROS_IP=127.0.0.1', '', HERE),
    ('ROS_HOSTNAME=ip6-localhost ROS_IP=192.0.2.1', '', HERE), ('ROS_HOSTNAME=robot.example', '', 'robot.example'),
    ('ROS_HOSTNAME=localhost', '--host 192.0.2.1', '192.0.2.1')])
def test_each_name_of_loopback_is_the_same_and_others_stay(settings, options, shown):
    """The first of them that says something decides, as for rospy."""
    show = run('env', *(f'--unset={name}' for name in SET_BY_WS), *settings.split(), ROOT / 'ws',
               *options.split(), 'printenv', *SET_BY_WS, status=None)
    assert show.stdout.startswith(shown), show.output


def test_a_launch_in_a_shell_listens_on_loopback_only(tmp_path):
    """Master, rosout, nodes; even if ~/.bashrc, which the shell reads, wishes otherwise."""
    environment = {'HOME': str(tmp_path), 'PATH': os.environ['PATH'], 'TERM': 'xterm'}
    with hold_port() as port, Terminal(ROOT, environment) as terminal:
        (tmp_path / '.bashrc').write_text('export ROS_HOSTNAME=0.0.0.0\n')
        terminal.type('ROS_IP=127.0.0.1 ./ws shell')
        terminal.wait_for_prompt()
        terminal.type(f'roslaunch -p {port} odometry_launch move_two_meters.launch')
        terminal.wait_for_output('driving at')
        assert_loopback_only(terminal.pid)
        terminal.press_ctrl_c()
        terminal.wait_for_prompt()


@pytest.mark.parametrize('options', [[], ['--host', '127.0.0.1']])
def test_dask_and_its_dashboards_listen_on_loopback_only(options):
    with hold_port() as port, Process(ROOT / 'ws', 'dask', 'scheduler', '--port', port, *options) as scheduler:
        scheduler.wait_for_output('dashboard at', DASK_TIMEOUT)
        assert_loopback_only(scheduler.pid)
        with Process(ROOT / 'ws', 'dask', 'worker', f'tcp://127.0.0.1:{port}', *options) as worker:
            worker.wait_for_output('Registered to', DASK_TIMEOUT)
            assert_loopback_only(worker.pid)


@pytest.mark.parametrize('setting', ['ROS_IP=192.0.2.1', 'ROS_HOSTNAME=robot.invalid'])
def test_an_address_of_another_network_is_named_and_stops_no_demo(setting):
    """As a lab's ~/.bashrc leaves it; the demo has a ROS master of its own."""
    named = run('env', '--unset=ROS_HOSTNAME', setting, ROOT / 'ws', 'true')
    assert named.output.strip() == (
        f'./ws: {setting} is not an address of this machine, so other nodes cannot reach yours: unset it, '
        'or give --host one that ip -br address lists')
    with hold_port() as port:
        demo = run('env', '--unset=ROS_HOSTNAME', setting, f'ROS_MASTER_URI=http://localhost:{port}',
                   ROOT / 'ws', 'demo', '--distance', '0.1', '--real-time-factor', '0', timeout=60.0)
    assert not demo.stderr
