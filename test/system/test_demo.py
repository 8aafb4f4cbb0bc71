"""The main job: ./ws demo, from its first line to the picture it leaves."""

import os
import re
from pathlib import Path

import rosbag
from odometry_tests.forms import number_after
from odometry_tests.processes import Process, hold_port
from odometry_tests.scripts import ROOT

PNG = b'\x89PNG'


def demo(*arguments, **env):
    """Run ./ws demo to its end and return its process."""
    process = Process(ROOT / 'ws', 'demo', *arguments, env=env)
    process.wait(90.0)
    return process


def test_the_demo_drives_two_metres_and_leaves_a_picture():
    """Exit status 0, both distances as at each factor but one, a bag and a PNG."""
    with hold_port() as port:
        run = demo('--real-time-factor', '20', ROS_MASTER_URI=f'http://localhost:{port}')
    assert run.wait() == 0, run.output
    assert number_after('moved distance', run.stdout) == 2.005
    assert number_after('true distance', run.stdout) == 2.005
    assert re.search('^.* of 2.00 m', run.stdout, re.MULTILINE), 'no progress in plain lines'
    picture = re.search(r'picture +(.*)', run.stdout).group(1)
    assert Path(picture).resolve().parents[1] == Path(os.environ['ODOMETRY_RUNS'])
    with open(picture, 'rb') as file:
        assert file.read(4) == PNG
    with rosbag.Bag(picture.replace('run.png', 'run.bag')) as bag:
        topics = set(bag.get_type_and_topic_info().topics)
    assert topics == {'/odom', '/base_pose_ground_truth', '/moved_distance', '/cmd_vel'}


def test_two_runs_print_the_same_of_their_arrival():
    """The last line of progress and the summary, but for the real time that they took."""
    with hold_port() as port:
        first, second = (
            demo('rotate', '--real-time-factor', '0', ROS_MASTER_URI=f'http://localhost:{port}')
            for _ in range(2))
    assert arrival(first) == arrival(second)
    assert arrival(first)[0].endswith(f' {number_after("time", first.stdout)} s'), first.output


def arrival(run):
    """Return what a demo has printed of its arrival in lockstep."""
    lines = re.sub(', .* real$', '', run.stdout, flags=re.MULTILINE).splitlines()
    *_, start = (number for number, line in enumerate(lines) if line.startswith('['))
    assert len(lines[start:]) == 5, run.output
    return lines[start:-1]  # then comes the picture


def test_a_bad_option_gets_one_clear_line():
    """And exit status 2, before anything is started; unit/test_demo_options.py has the others."""
    run = demo('--speed', '0')
    assert run.wait() == 2
    assert run.stdout == ''
    assert run.stderr.splitlines()[-1].startswith('./ws demo: error: argument --speed')
