"""./ws demo, from its first line to the picture it leaves, alone and beside others."""

import os
import re
from pathlib import Path

import pytest
import rosbag
from odometry_tests.forms import number_after
from odometry_tests.processes import Process, hold_port
from odometry_tests.scripts import ROOT

PNG = b'\x89PNG'


def start(port, *arguments):
    """Start a demo that has this port for its master if it is free."""
    return Process(ROOT / 'ws', 'demo', *arguments,
                   env={'ROS_MASTER_URI': f'http://localhost:{port}'})


def test_it_drives_two_metres_and_leaves_a_bag_and_a_picture():
    """In lockstep the distances are the same at each pace."""
    with hold_port() as port, start(port, '--real-time-factor', '0') as run:
        assert run.wait(90.0) == 0, run.output
    assert number_after('moved distance', run.stdout) == 2.005
    assert number_after('true distance', run.stdout) == 2.005
    assert re.search('^.* of 2.00 m', run.stdout, re.MULTILINE), 'no progress in plain lines'
    picture = re.search(r'picture +(.*)', run.stdout).group(1)
    assert Path(picture).resolve().parents[1] == Path(os.environ['ODOMETRY_RUNS'])
    assert Path(picture).read_bytes().startswith(PNG)
    with rosbag.Bag(picture.replace('run.png', 'run.bag')) as bag:
        topics = set(bag.get_type_and_topic_info().topics)
    assert topics == {'/odom', '/base_pose_ground_truth', '/moved_distance', '/cmd_vel'}


@pytest.mark.nightly
def test_demos_that_start_together_all_arrive():
    """The one without the usual port says where its master is, and each has its own folder."""
    with hold_port() as port:
        demos = [start(port, '--distance', '0.3', '--real-time-factor', '0') for _ in range(2)]
        for demo in demos:
            assert demo.wait(90.0) == 0, demo.output
    output = '\n'.join(demo.output for demo in demos)
    told, = re.findall(r'^rostopic in another terminal: export ROS_MASTER_URI=.*:(\d+)$', output,
                       re.MULTILINE)
    assert int(told) != port
    assert len(set(re.findall('^picture +(.*)', output, re.MULTILINE))) == 2, output
