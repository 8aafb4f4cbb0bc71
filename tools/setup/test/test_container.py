"""The container, built and used as docs/container.md says, by Docker or else Podman."""

import os
import re
import shutil

import psutil
import pytest
from checkout import make_package
from odometry_tests.processes import run
from odometry_tests.scripts import DOCUMENTS, ROOT
from odometry_tests.terminal import Terminal

# What the documents show.
BUILD = 'docker build -t turtlebot2-odometry .'
RUN = 'docker run --rm -it --name robot -p 127.0.0.1:8080:8080 turtlebot2-odometry'
SHELL = f'{RUN} shell'
NEXT_SHELL = 'docker exec -it robot ./ws shell'
PACKAGES = SHELL.replace('8080 t', '8080 -v "$PWD/packages:/odometry/.ws/src/packages" t')
RUNS = RUN.replace('8080 t', '8080 -v "$PWD/runs:/odometry/runs" --user "$(id -u):$(id -g)" t')
TYPED = [f'{BUILD} && {RUN}', SHELL, NEXT_SHELL, PACKAGES, RUNS]
BUILD_TIMEOUT = 900.0  # s
START_TIMEOUT = 60.0  # s
pytestmark = pytest.mark.nightly


class Engine:
    """Docker, or Podman with the same commands."""

    def __init__(self):
        self._name = next(filter(shutil.which, ('docker', 'podman')), None)
        if not self._name or run(self._name, 'info', status=None).wait():
            pytest.skip('neither Docker nor Podman can be used here')
        if self.addresses():
            pytest.skip('port 8080 is taken')
        with self.terminal(ROOT, BUILD) as terminal:
            assert terminal.wait_for_prompt(BUILD_TIMEOUT) == 0, terminal.output

    def terminal(self, folder, line):
        """Open a terminal and type a line, in which docker's name stands for either."""
        terminal = Terminal(folder, os.environ)
        terminal.type(re.sub('^docker', self._name, line))
        return terminal

    def run(self, *arguments):
        return run(self._name, *arguments).stdout

    @staticmethod
    def addresses():
        """Return at which of this machine's addresses its page is reached."""
        return {socket.laddr.ip for socket in psutil.net_connections('tcp')
                if socket.laddr.port == 8080 and socket.status == psutil.CONN_LISTEN}


@pytest.fixture(scope='module')
def built_engine():
    return Engine()


@pytest.fixture
def engine(built_engine):
    """Return it; nothing is left at the end, or it would be in the way of the next test."""
    yield built_engine
    left = built_engine.run('ps', '--all', '--quiet', '--filter', 'name=^robot$'), built_engine.addresses()
    built_engine.run('rm', '--force', 'robot')
    assert left == ('', set())


def test_the_documents_show_what_is_typed_here():
    shown = '\n'.join(path.read_text() for path in DOCUMENTS)
    assert [line for line in TYPED if line not in shown] == []


def test_it_drives_and_its_page_alone_is_reached(engine, tmp_path):
    (tmp_path / 'runs').mkdir()
    with engine.terminal(tmp_path, RUNS) as terminal:
        terminal.wait_for_output('The page stays', START_TIMEOUT)
        assert re.search(r'\[=+\] 2\.00 of 2\.00 m, 0\.00 m/s', terminal.output), terminal.output
        assert 'view            http://localhost:8080' in terminal.lines
        assert engine.addresses() == {'127.0.0.1'}
        terminal.press_ctrl_c()
        assert terminal.wait_for_prompt() == 0, terminal.output
    run, = (tmp_path / 'runs').iterdir()
    assert {path.name for path in run.iterdir()} == {'run.bag', 'run.png'}
    assert run.stat().st_uid == tmp_path.stat().st_uid


def test_the_tutorials_are_typed_in_its_shells(engine, tmp_path):
    """A second shell in the same container sees the first one's robot; packages are built."""
    make_package(tmp_path / 'packages/hello', 'rospy')
    with engine.terminal(tmp_path, PACKAGES) as terminal:
        terminal.wait_for_output('(ws) ', START_TIMEOUT)
        terminal.type('roslaunch odometry_launch sim.launch')
        terminal.wait_for_output('process[sim_turtlebot', START_TIMEOUT)
        with engine.terminal(tmp_path, NEXT_SHELL) as other:
            other.wait_for_output('(ws) ', START_TIMEOUT)
            for line, answer in [('rostopic echo /odom -n1', 'child_frame_id: "base_footprint"'),
                                 ('rosrun hello hello.py', 'hello from rospy'),
                                 ('rosrun odom_movement_detector odom_movement_detector.py &', '[1] '),
                                 ('rostopic echo /moved_distance -n1', 'data: 0.0')]:
                other.type(line)
                other.wait_for_output(answer, START_TIMEOUT)
        terminal.press_ctrl_c()
        terminal.wait_for_output('(ws) ')
        terminal.type('exit')
        terminal.wait_for_prompt()
