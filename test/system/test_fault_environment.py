"""Machines that lack something: a home, a writable log, a network that may be listened to."""

import os
import socket
import subprocess

import pytest
import rosgraph
from odometry_tests.linux import needs_children
from odometry_tests.processes import Process, hold_port
from odometry_tests.scripts import ROOT
from odometry_tests.tutorial import detector, mover, rotator, simulator
from odometry_tests.waiting import Recorder, wait_until
from std_msgs.msg import Float64

NODES = [simulator, detector, mover, rotator]
LISTENING = '0A'  # a state of TCP sockets in /proc/net/tcp


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
    with open(path, 'wb', buffering=0) as file:
        try:
            while file.write(bytes(1024)):
                pass
        except OSError:
            pass


def test_the_robot_drives_when_nothing_can_be_logged(master, log_folder):
    """Logs are a convenience: without them the nodes run all the same."""
    environment = {'ROS_LOG_DIR': str(log_folder)}
    moved = Recorder('moved_distance', Float64)
    with simulator(env=environment) as robot, detector(env=environment) as counter, \
            mover(env=environment) as driver:
        moved.wait_for(lambda m: m.data > 0.05, 30.0,
                       lambda: f'movement; {robot.output} {counter.output} {driver.output}')
        for process in (driver, counter, robot):
            assert process.end() == 0, process.output
            assert 'Traceback' not in process.output


@pytest.mark.parametrize('start', NODES)
def test_a_node_runs_without_a_home(master, start, monkeypatch):
    """HOME is unset in many a container and service."""
    monkeypatch.delenv('HOME')
    name = f'homeless_{start.__name__}'
    with start(f'__name:={name}') as node:
        wait_until(lambda: known(name), 20.0,
                   lambda: f'the node; it printed {node.output}')
        assert node.end() == 0, node.output
    assert 'Traceback' not in node.output


def known(name):
    """Tell whether a node has registered."""
    try:
        return bool(rosgraph.Master('/test').lookupNode(f'/{name}'))
    except rosgraph.MasterError:
        return False


def descendants(pid):
    """Return the ids of a process and of all that it has started."""
    with open(f'/proc/{pid}/task/{pid}/children') as children:
        found = [int(child) for child in children.read().split()]
    return [pid] + [deeper for child in found for deeper in descendants(child)]


def listening_addresses(pids):
    """Return the IP addresses on which these processes listen for TCP connections."""
    inodes = set()
    for pid in pids:
        for entry in os.scandir(f'/proc/{pid}/fd'):
            try:
                target = os.readlink(entry.path)
            except OSError:
                continue
            if target.startswith('socket:['):
                inodes.add(target[len('socket:['):-1])
    addresses = set()
    for table, family in (('tcp', socket.AF_INET), ('tcp6', socket.AF_INET6)):
        with open(f'/proc/net/{table}') as rows:
            for row in list(rows)[1:]:
                fields = row.split()
                if fields[3] == LISTENING and fields[9] in inodes:
                    addresses.add(readable(fields[1].split(':')[0], family))
    return addresses


def readable(hexadecimal, family):
    """Return an address of /proc/net in the usual form: its words are in host byte order."""
    words = [bytes.fromhex(hexadecimal[start:start + 8])[::-1]
             for start in range(0, len(hexadecimal), 8)]
    return socket.inet_ntop(family, b''.join(words))


@needs_children
def test_everything_that_ws_starts_listens_on_loopback_only(master):
    """Master, rosout, nodes: nobody else on the network can drive the robot."""
    clean = {name: value for name, value in os.environ.items()
             if name not in ('ROS_HOSTNAME', 'ROS_IP', 'ROS_ETC_DIR')}
    with hold_port() as port, Process(
            'env', '-i', *(f'{name}={value}' for name, value in clean.items()),
            ROOT / 'ws', 'roslaunch', '-p', port, 'odometry_launch',
            'move_two_meters.launch') as launch:
        launch.wait_for_output('driving at', 60.0)
        addresses = listening_addresses(descendants(launch.pid))
    assert addresses and addresses <= {'127.0.0.1', '::1'}, addresses


def test_ws_host_lets_others_in(master):
    """Deliberately: the nodes then tell others the address they are given."""
    show = Process(ROOT / 'ws', '--host', '192.0.2.1', 'printenv', 'ROS_IP',
                   env={'ROS_HOSTNAME': ''})
    assert show.wait(30.0) == 0, show.output
    assert show.stdout == '192.0.2.1'
