"""Machines that lack something: a home, a writable log."""

import contextlib
import subprocess

import pytest
import rosnode
from odometry_launch.process_guard import GuardedProcess
from odometry_tests.tutorial import detector, mover, rotator, simulator
from odometry_tests.waiting import Recorder, wait_until
from std_msgs.msg import Float64

NODES = [simulator, detector, mover, rotator]


@pytest.fixture(params=['full', 'read-only', 'missing'])
def log_folder(request, tmp_path):
    """Provide a folder for logs that cannot be used, each time for another reason."""
    folder = tmp_path / 'log'
    if request.param == 'missing':
        (tmp_path / 'file').write_text('')
        yield tmp_path / 'file' / 'log'
        return
    folder.mkdir()
    options = 'size=4k' if request.param == 'full' else 'ro'
    mount = subprocess.run(['mount', '-t', 'tmpfs', '-o', options, 'tmpfs', folder],
                           capture_output=True, text=True, check=False)
    if mount.returncode:
        pytest.skip(f'nothing can be mounted here: {mount.stderr.strip()}')
    try:
        if request.param == 'full':
            fill(folder / 'filler')
        yield folder
    finally:
        subprocess.run(['umount', '-l', folder], check=True)


def fill(path):
    """Write until the disk is full."""
    with contextlib.suppress(OSError), open(path, 'wb', buffering=0) as file:
        while file.write(bytes(1024)):
            pass


def test_the_robot_drives_when_nothing_can_be_logged(master, log_folder):
    """Logs are a convenience: without them the nodes run all the same."""
    moved = Recorder('moved_distance', Float64)
    options = {'env': {'ROS_LOG_DIR': str(log_folder)}, 'start': GuardedProcess}
    with simulator(**options) as robot, detector(**options) as counter, \
            mover(**options) as driver:
        moved.wait_for(lambda m: m.data > 0.05, 30.0,
                       lambda: f'movement; {robot.output} {counter.output} {driver.output}')
        for process in (driver, counter, robot):
            assert process.end() == 0, process.output


@pytest.mark.parametrize('start', NODES)
def test_a_node_runs_without_a_home(master, start, monkeypatch):
    """HOME is unset in many a container and service."""
    monkeypatch.delenv('HOME')
    name = f'homeless_{start.__name__}'
    with start(f'__name:={name}', start=GuardedProcess) as node:
        wait_until(lambda: f'/{name}' in rosnode.get_node_names(), 20.0,
                   lambda: f'the node; it printed {node.output}', period=0.1)
        assert node.end() == 0, node.output
