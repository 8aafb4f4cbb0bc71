"""Machines that lack a home, a disk or speed; the nodes take the files that they need, and no more."""

import contextlib
import os
import re
import resource
import signal
import subprocess
from pathlib import Path

import numpy
import psutil
import pytest
from nav_msgs.msg import Odometry
from odometry_tests.pausing import call, pause
from odometry_tests.processes import Process, path_of
from odometry_tests.tutorial import Truth, detector, mover, simulator, simulator_in_step
from odometry_tests.waiting import Recorder
from std_msgs.msg import Float64, String

# In a namespace of mounts that ends with the node; the folder is $0.
FAULTS = {'full': 'mount -t tmpfs -o size=4k tmpfs "$0"; head -c 8k /dev/zero >"$0/filler" || true; exec "$@"',
          'missing': 'rmdir "$0"; touch "$0"; exec "$@"', 'no home': 'unset HOME ROS_LOG_DIR; exec "$@"'}
ROBOTS = 12  # need more than 64 files
HALF, PART = 8, 100  # parts; s of the robot's time in each
MORE_MEMORY, ALLOWED = 1.0, (2, 3)  # MB in each part; threads and files in all


@pytest.mark.parametrize('fault', FAULTS)
def test_the_robot_drives_when_nothing_can_be_logged(master, fault, tmp_path):
    """Logs are a convenience, and HOME is unset in many a container."""
    if subprocess.run(['unshare', '--mount', 'true'], check=False).returncode:
        pytest.skip('nothing can be mounted here')
    moved = Recorder('moved_distance', Float64)

    def start(package, program):
        folder = tmp_path / package
        folder.mkdir()
        return Process('unshare', '--mount', 'sh', '-ec', FAULTS[fault], folder, path_of(package, program),
                       env={'ROS_LOG_DIR': str(folder)})

    with start('sim_turtlebot', 'sim_turtlebot_node.py') as robot, start('test_movement', 'test_movement.py') as driver, \
            start('odom_movement_detector', 'odom_movement_detector.py') as counter:
        moved.wait_for(lambda m: m.data > 0.05, 30.0,
                       lambda: f'movement; {robot.output} {counter.output} {driver.output}')
        for process in driver, counter, robot:
            assert process.end() == 0, process.output


def test_a_pace_that_no_machine_can_keep_is_told_of_once(simulated_time):
    with simulator('_odom_rate:=1000', '_real_time_factor:=1000',
                   env={'ROS_NAMESPACE': 'fast'}) as robot:
        robot.wait_for_output('too slow')
        warning = Recorder('/fast/sim_turtlebot/warning', String).wait_for(lambda m: m.data)
        assert robot.end() == 0, robot.output
    line, = robot.stderr.splitlines()
    assert warning.data in line
    assert re.search(r'reaches a real-time factor of [\d.]+ instead of 1000$', line), line


def test_a_node_takes_more_file_descriptors_than_usual_if_it_may(master):
    """Of many robots each topic takes one, and 1024 are usual."""
    with simulator(f'_robots:={ROBOTS}', env={'ROS_NAMESPACE': 'many'},
                   preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (64, 1024))):
        Recorder(f'/many/robot_{ROBOTS}/odom', Odometry).wait_for()


def usage(process):
    found = psutil.Process(process.pid)
    files = []
    for file in Path(f'/proc/{process.pid}/fd').iterdir():
        with contextlib.suppress(FileNotFoundError):  # it was closed meanwhile
            files.append(os.readlink(file))
    # Lockstep's files of other threads come and go with these.
    kept = [file for file in files if not (file.startswith('/proc/') and os.path.exists(file))]
    return found.memory_info().rss / 2**20, found.num_threads(), len(kept)


@pytest.mark.nightly
def test_memory_threads_and_files_stay_the_same(simulated_time, master):
    truth = Truth()
    with simulator_in_step('_real_time_factor:=0', '_scan:=true') as robot, detector() as counter, \
            mover('_distance:=1000000') as driver:
        used = []
        for _ in range(2 * HALF):
            with detector('__name:=killed') as killed:
                truth.wait_for(lambda m: m.header.stamp.to_sec() > PART, 120.0, 'the end of a part')
                killed.send(signal.SIGKILL)
                killed.wait()
            pause(truth)
            used.append({name: usage(process) for name, process in [
                ('simulator', robot), ('detector', counter), ('mover', driver), ('master', master)]})
            truth.clear()
            call('reset_simulation')
            call('unpause_physics')
    for name in used[0]:
        memory, *counts = zip(*(part[name] for part in used))
        # A leak grows in each part; beside other tests lockstep's heap fills in the first ten.
        assert numpy.median(numpy.diff(memory)) <= MORE_MEMORY, (name, memory)
        for count, allowed in zip(counts, ALLOWED):  # they come and go
            assert min(count[HALF:]) - min(count[:HALF]) <= allowed, (name, counts)
