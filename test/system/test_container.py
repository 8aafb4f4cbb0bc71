"""The container, built and used as docs/container.md says, by Podman."""

import json
import re

import pytest
from odometry_tests.containers import NotHere, Podman
from odometry_tests.documents import FENCE, README
from odometry_tests.scripts import ROOT
from odometry_tests.terminal import Terminal
from odometry_tests.waiting import wait_until

PAGE = ROOT / 'docs' / 'container.md'
BUILD = 'docker build -t turtlebot2-odometry .'
RUN = 'docker run --rm -it --name robot -p 127.0.0.1:8080:8080 turtlebot2-odometry'
IMAGE = 'turtlebot2-odometry'
BUILD_TIMEOUT = 900.0  # s
START_TIMEOUT = 60.0  # s
SOMEBODY = '12345:12345'
ENDED_BY_SIGTERM = 128 + 15
LISTENS = re.compile(r'^ *\d+: ([0-9A-F]+):([0-9A-F]{4}) \S+ 0A ', re.MULTILINE)
LOOPBACK = {'0100007F', '0' * 24 + '01000000'}
HELLO = {
    'package.xml': """<package format="3">
  <name>hello</name>
  <version>1.0.0</version>
  <description>A package of the user's own.</description>
  <maintainer email="me@example.com">Me</maintainer>
  <license>BSD</license>
  <buildtool_depend>catkin</buildtool_depend>
</package>
""",
    # As teleop_twist_keyboard has it: CMake then looks for compilers.
    'CMakeLists.txt': """cmake_minimum_required(VERSION 3.0.2)
project(hello)
find_package(catkin REQUIRED)
catkin_package()
catkin_install_python(PROGRAMS hello.py DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
""",
    'hello.py': '#!/usr/bin/env python3\nimport rospy\nprint("hello from", rospy.__name__)\n'}


@pytest.fixture(scope='module')
def podman(tmp_path_factory):
    """Build the image, as a reader does."""
    try:
        with Podman(tmp_path_factory.mktemp('podman')) as podman:
            with Terminal(ROOT, podman.environment) as terminal:
                terminal.type(BUILD)
                assert terminal.wait_for_prompt(BUILD_TIMEOUT) == 0, terminal.output
            yield podman
    except NotHere as reason:
        pytest.skip(str(reason))


@pytest.fixture
def terminal(podman):
    """Open a terminal, in which docker's name stands for Podman."""
    with Terminal(ROOT, podman.environment) as terminal:
        yield terminal


def outside_loopback(podman, name):
    """Return the ports of a container on which something listens that not only it itself reaches."""
    table = podman.run('exec', name, 'cat', '/proc/net/tcp', '/proc/net/tcp6')
    listening = LISTENS.findall(table)
    assert len(listening) > 3, table
    return {int(port, 16) for address, port in listening if address not in LOOPBACK}


def test_the_documents_have_these_commands():
    """So that what is run here is what a reader types."""
    readme, page = README.read_text(), PAGE.read_text()
    assert f'{BUILD}\n{RUN}' in readme
    for line in (BUILD, RUN, f'{RUN} shell', 'docker exec -it robot ./ws shell'):
        assert f'\n{line}\n' in page, line
    assert FENCE in page


def test_it_drives_and_its_page_alone_is_reached(podman, terminal):
    """Until Ctrl-C, which is no failure and leaves nothing."""
    terminal.type(RUN)
    terminal.wait_for_output('The page stays', START_TIMEOUT)
    assert re.search(r'\[=+\] 2\.00 of 2\.00 m, 0\.00 m/s', terminal.output), terminal.output
    assert 'view            http://localhost:8080\n' in terminal.output
    assert podman.listening() == {'127.0.0.1 8080'}
    assert outside_loopback(podman, 'robot') == {8080}
    assert podman.fetch(8080, 'localhost') == 200
    own, other = 'http://localhost:8080', 'http://evil.example'
    assert podman.fetch(8080, Host='localhost:8080', Origin=own) == 200
    assert podman.fetch(8080, Host='localhost:8080', Origin=other) == 403
    assert podman.fetch(8080, Host='evil.example:8080') == 403
    terminal.press_ctrl_c()
    assert terminal.wait_for_prompt() == 0, terminal.output
    assert podman.run('ps', '--all', '--quiet') == ''


def test_ctrl_c_while_it_drives_ends_it(podman, terminal):
    """With the status of Ctrl-C; the page has another port here."""
    terminal.type(RUN.replace(':8080:', ':9000:') + ' demo --view --distance 100')
    terminal.wait_for_output('of 100.00 m', START_TIMEOUT)
    assert podman.listening() == {'127.0.0.1 9000'}
    assert podman.fetch(9000, Host='localhost:9000', Origin='http://localhost:9000') == 200
    terminal.press_ctrl_c()
    assert terminal.wait_for_prompt() == 130, terminal.output
    assert 'Traceback' not in terminal.output
    assert podman.run('ps', '--all', '--quiet') == ''


def test_it_ends_when_it_is_stopped(podman):
    """By SIGTERM: the status would be 137 if it had to be killed."""
    podman.run('run', '--detach', '--name', 'stopped', IMAGE, 'demo', '--distance', '100')
    wait_until(lambda: 'of 100.00 m' in podman.run('logs', 'stopped'), START_TIMEOUT, 'driving')
    podman.run('stop', '--time', '60', 'stopped')
    assert int(podman.run('wait', 'stopped')) == ENDED_BY_SIGTERM
    podman.run('rm', 'stopped')


def test_whoever_runs_it_has_the_runs(podman, tmp_path):
    """Any user, to whom neither the checkout nor a home belongs."""
    runs = tmp_path / 'runs'
    runs.mkdir()
    tmp_path.chmod(0o755)
    runs.chmod(0o777)
    output = podman.run('run', '--rm', '--user', SOMEBODY, '-v', f'{runs}:/odometry/runs', IMAGE,
                        'demo', '--view', '--distance', '0.2', '--real-time-factor', '0')
    assert '0.20 of 0.20 m' in output
    run, = runs.iterdir()
    assert {path.name for path in run.iterdir()} == {'run.bag', 'run.png'}
    assert {path.stat().st_uid for path in run.iterdir()} == {int(SOMEBODY.partition(':')[0])}


@pytest.mark.parametrize('user', ['', f'--user {SOMEBODY} '])
def test_the_tutorials_are_typed_in_its_shells(podman, terminal, tmp_path, user):
    """A second shell in the same container sees the first one's robot; packages are built."""
    for name, content in HELLO.items():
        (tmp_path / name).write_text(content)
    (tmp_path / 'hello.py').chmod(0o755)
    tmp_path.chmod(0o755)
    mounted = f'--rm {user}-v {tmp_path}:/odometry/.ws/src/hello '
    terminal.type(RUN.replace('--rm ', mounted) + ' shell')
    terminal.wait_for_output('(ws) ', START_TIMEOUT)
    terminal.type('roslaunch odometry_launch sim.launch')
    terminal.wait_for_output('process[sim_turtlebot', START_TIMEOUT)
    with Terminal(ROOT, podman.environment) as other:
        other.type('docker exec -it robot ./ws shell')
        other.wait_for_output('(ws) ', START_TIMEOUT)
        for line, answer in [('rostopic echo /odom -n1', 'child_frame_id: "base_footprint"'),
                             ('rosrun hello hello.py', 'hello from rospy'),
                             ('rosrun odom_movement_detector odom_movement_detector.py &', '[INFO]'),
                             ('rostopic echo /moved_distance -n1', 'data: 0.0'),
                             ('git --version', 'git version')]:
            other.type(line)
            other.wait_for_output(answer, START_TIMEOUT)
    terminal.press_ctrl_c()
    terminal.wait_for_output('(ws) ')
    terminal.type('exit')
    terminal.wait_for_prompt()
    assert podman.run('ps', '--all', '--quiet') == ''


def test_the_devcontainer_is_this_container():
    """An editor forwards the port to its container's loopback."""
    settings = json.loads((ROOT / '.devcontainer' / 'devcontainer.json').read_text())
    folder = ROOT / '.devcontainer'
    assert (folder / settings['build']['dockerfile']).resolve() == ROOT / 'Dockerfile'
    assert (folder / settings['build']['context']).resolve() == ROOT
    assert settings['forwardPorts'] == [8080]
    assert settings['remoteUser'] in (ROOT / 'Dockerfile').read_text()
    assert settings['containerEnv'] == {'ODOMETRY_VIEW_HOST': 'localhost'}
