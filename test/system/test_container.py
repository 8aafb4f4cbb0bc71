"""The container, built and used as docs/container.md says, by Podman."""

import os
import re

import pytest
from odometry_tests.containers import NotHere, Podman
from odometry_tests.documents import DOCUMENTS
from odometry_tests.own_package import make_package
from odometry_tests.scripts import ROOT
from odometry_tests.terminal import Terminal

# What the documents show.
BUILD = 'docker build -t turtlebot2-odometry .'
RUN = 'docker run --rm -it --name robot -p 127.0.0.1:8080:8080 turtlebot2-odometry'
SHELL = f'{RUN} shell'
NEXT_SHELL = 'docker exec -it robot ./ws shell'
PACKAGES = SHELL.replace('8080 t', '8080 -v "$PWD/packages:/odometry/.ws/src/packages" t')
RUNS = RUN.replace('8080 t', '8080 -v "$PWD/runs:/odometry/runs" --user "$(id -u):$(id -g)" t')
FAST = 'docker run --rm turtlebot2-odometry demo --real-time-factor 0'
STOP = 'docker stop robot'
TYPED = [f'{BUILD} && {RUN}', SHELL, NEXT_SHELL, PACKAGES, RUNS, FAST, STOP]
MYSELF, SOMEBODY = '"$(id -u):$(id -g)"', 12345
BUILD_TIMEOUT = 900.0  # s
START_TIMEOUT = 60.0  # s
ENDED_BY_SIGTERM = 128 + 15
LISTENS = re.compile(r'^ *\d+: ([0-9A-F]+):([0-9A-F]{4}) \S+ 0A ', re.MULTILINE)
LOOPBACK = {'0100007F', '0' * 24 + '01000000'}


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
def terminal(podman, tmp_path):
    """Open a terminal, in which docker's name stands for Podman."""
    with Terminal(tmp_path, podman.environment) as terminal:
        yield terminal
    # What a test that has failed has left would be in the way of the next.
    podman.forget_containers()


def outside_loopback(podman):
    """Return the ports in the container that are listened on for more than itself."""
    table = podman.run('exec', 'robot', 'cat', '/proc/net/tcp', '/proc/net/tcp6')
    listening = LISTENS.findall(table)
    assert len(listening) > 3, table
    return {int(port, 16) for address, port in listening if address not in LOOPBACK}


def assert_nothing_is_left(podman):
    """Assert that there is no container, and nobody listens any more."""
    assert podman.run('ps', '--all', '--quiet') == ''
    assert podman.listening() == set()


def test_the_documents_show_what_is_typed_here():
    """Line by line."""
    shown = '\n'.join(path.read_text() for path in DOCUMENTS)
    assert [line for line in TYPED if line not in shown] == []


def test_it_drives_and_its_page_alone_is_reached(podman, terminal):
    """Until Ctrl-C, which is no failure and leaves nothing."""
    terminal.type(RUN)
    terminal.wait_for_output('The page stays', START_TIMEOUT)
    assert re.search(r'\[=+\] 2\.00 of 2\.00 m, 0\.00 m/s', terminal.output), terminal.output
    assert 'view            http://localhost:8080' in terminal.lines
    assert podman.listening() == {'127.0.0.1 8080'}
    assert outside_loopback(podman) == {8080}
    assert podman.fetch(8080, 'localhost') == 200
    own = {'Host': 'localhost:8080', 'Origin': 'http://localhost:8080'}
    assert podman.fetch(8080, **own) == 200
    assert podman.fetch(8080, **{**own, 'Origin': 'http://evil.example'}) == 403
    assert podman.fetch(8080, Host='evil.example:8080') == 403
    terminal.press_ctrl_c()
    assert terminal.wait_for_prompt() == 0, terminal.output
    assert_nothing_is_left(podman)


def test_it_ends_when_it_is_stopped(podman, terminal):
    """By SIGTERM: the status would be 137 if it had to be killed."""
    terminal.type(f'{RUN} demo --view --distance 100')
    terminal.wait_for_output('of 100.00 m', START_TIMEOUT)
    with Terminal(ROOT, podman.environment) as other:
        # On a slow machine it may need more than the usual ten seconds.
        other.type(STOP.replace('stop', 'stop --time 60'))
        assert other.wait_for_prompt(60.0) == 0, other.output
    assert terminal.wait_for_prompt() == ENDED_BY_SIGTERM, terminal.output
    assert_nothing_is_left(podman)


def test_without_a_terminal_it_ends_by_itself(podman, terminal):
    """As fast as the machine can."""
    terminal.type(FAST)
    assert terminal.wait_for_prompt(START_TIMEOUT) == 0, terminal.output
    assert '2.00 of 2.00 m' in terminal.output


def test_whoever_runs_it_has_the_runs(podman, terminal, tmp_path):
    """Any user, to whom neither the checkout nor a home belongs."""
    runs = tmp_path / 'runs'
    runs.mkdir()
    os.chown(runs, SOMEBODY, SOMEBODY)
    somebody = RUNS.replace(MYSELF, f'{SOMEBODY}:{SOMEBODY}')
    terminal.type(f'{somebody} demo --distance 0.2 --real-time-factor 0')
    assert terminal.wait_for_prompt(START_TIMEOUT) == 0, terminal.output
    assert '0.20 of 0.20 m' in terminal.output
    run, = runs.iterdir()
    assert {path.name for path in run.iterdir()} == {'run.bag', 'run.png'}
    assert {path.stat().st_uid for path in run.iterdir()} == {SOMEBODY}


@pytest.mark.parametrize('user', ['', f'--user {SOMEBODY}:{SOMEBODY}'])
def test_the_tutorials_are_typed_in_its_shells(podman, terminal, tmp_path, user):
    """A second shell in the same container sees the first one's robot; packages are built."""
    make_package(tmp_path / 'packages' / 'hello', 'rospy')
    terminal.type(PACKAGES.replace('--rm', f'--rm {user}'))
    terminal.wait_for_output('(ws) ', START_TIMEOUT)
    terminal.type('roslaunch odometry_launch sim.launch')
    terminal.wait_for_output('process[sim_turtlebot', START_TIMEOUT)
    with Terminal(ROOT, podman.environment) as other:
        other.type(NEXT_SHELL)
        other.wait_for_output('(ws) ', START_TIMEOUT)
        for line, answer in [('rostopic echo /odom -n1', 'child_frame_id: "base_footprint"'),
                             ('rosrun hello hello.py', 'hello from rospy'),
                             ('rosrun odom_movement_detector odom_movement_detector.py &', '[1] '),
                             ('rostopic echo /moved_distance -n1', 'data: 0.0'),
                             ('git --version', 'git version')]:
            other.type(line)
            other.wait_for_output(answer, START_TIMEOUT)
    assert outside_loopback(podman) == set()
    terminal.press_ctrl_c()
    terminal.wait_for_output('(ws) ')
    terminal.type('exit')
    terminal.wait_for_prompt()
    assert_nothing_is_left(podman)
