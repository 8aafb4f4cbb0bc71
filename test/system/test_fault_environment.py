"""Machines that lack something: a home, a writable log."""

import subprocess

import pytest
from odometry_tests.processes import Process, path_of
from odometry_tests.waiting import Recorder
from std_msgs.msg import Float64

NODES = {'simulator': ('sim_turtlebot', 'sim_turtlebot_node.py'),
         'detector': ('odom_movement_detector', 'odom_movement_detector.py'),
         'mover': ('test_movement', 'test_movement.py')}
# In a namespace of mounts that ends with the node; the folder is $0.
FAULTS = {'full': 'mount -t tmpfs -o size=4k tmpfs "$0"; head -c 8k /dev/zero >"$0/filler" || true; exec "$@"',
          'missing': 'rmdir "$0"; touch "$0"; exec "$@"', 'no home': 'unset HOME ROS_LOG_DIR; exec "$@"'}


@pytest.mark.parametrize('fault', FAULTS)
def test_the_robot_drives_when_nothing_can_be_logged(master, fault, tmp_path):
    """Logs are a convenience, and HOME is unset in many a container."""
    if subprocess.run(['unshare', '--mount', 'true'], check=False).returncode:
        pytest.skip('nothing can be mounted here')
    moved = Recorder('moved_distance', Float64)

    def start(name):
        folder = tmp_path / name
        folder.mkdir()
        return Process('unshare', '--mount', 'sh', '-ec', FAULTS[fault], folder, path_of(*NODES[name]),
                       env={'ROS_LOG_DIR': str(folder)})

    with start('simulator') as robot, start('detector') as counter, start('mover') as driver:
        moved.wait_for(lambda m: m.data > 0.05, 30.0,
                       lambda: f'movement; {robot.output} {counter.output} {driver.output}')
        for process in (driver, counter, robot):
            assert process.end() == 0, process.output
