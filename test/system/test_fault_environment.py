"""Machines that lack something: a home, a writable log."""

import subprocess
from functools import partial

import pytest
import rosnode
from odometry_launch.process_guard import GuardedProcess
from odometry_tests.tutorial import detector, mover, rotator, simulator
from odometry_tests.waiting import Recorder, wait_until
from std_msgs.msg import Float64

NODES = {'simulator': simulator, 'detector': detector, 'mover': mover, 'rotator': rotator}


# In a namespace of mounts that ends with the node; the folder is $0.
FAULTS = {'full': 'mount -t tmpfs -o size=4k tmpfs "$0"; head -c 8k /dev/zero >"$0/filler" || true; exec "$@"',
          'read-only': 'mount -t tmpfs -o ro tmpfs "$0"; exec "$@"',
          'missing': 'rmdir "$0"; touch "$0"; exec "$@"'}


@pytest.mark.parametrize('fault', FAULTS)
def test_the_robot_drives_when_nothing_can_be_logged(master, fault, tmp_path):
    """Logs are a convenience: without them the nodes run all the same."""
    if subprocess.run(['unshare', '--mount', 'true'], check=False).returncode:
        pytest.skip('nothing can be mounted here')
    moved = Recorder('moved_distance', Float64)

    def start(name):
        folder = tmp_path / name
        folder.mkdir()
        return NODES[name](env={'ROS_LOG_DIR': str(folder)}, start=partial(
            GuardedProcess, 'unshare', '--mount', 'sh', '-ec', FAULTS[fault], folder))

    with start('simulator') as robot, start('detector') as counter, start('mover') as driver:
        moved.wait_for(lambda m: m.data > 0.05, 30.0,
                       lambda: f'movement; {robot.output} {counter.output} {driver.output}')
        for process in (driver, counter, robot):
            assert process.end() == 0, process.output


@pytest.mark.parametrize('name', NODES)
def test_a_node_runs_without_a_home(master, name, monkeypatch):
    """HOME is unset in many a container and service."""
    monkeypatch.delenv('HOME')
    with NODES[name](f'__name:={name}') as node:
        wait_until(lambda: f'/{name}' in rosnode.get_node_names(), 20.0,
                   lambda: f'the node; it printed {node.output}', period=0.1)
        assert node.end() == 0, node.output
