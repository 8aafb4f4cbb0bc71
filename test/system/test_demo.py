"""The main job: ./ws demo, from its first line to the picture it leaves."""

import os
import pty
import re
import subprocess

import pytest
import rosbag
from odometry_tests.processes import Process, hold_port
from odometry_tests.scripts import ROOT

PNG = b'\x89PNG'


@pytest.fixture(autouse=True)
def port(monkeypatch):
    """Have the demo's ROS master on a port that no other test's demo can take."""
    with hold_port() as number:
        monkeypatch.setenv('ROS_MASTER_URI', f'http://localhost:{number}')
        yield


def demo(*arguments, factor=0):
    """Start ./ws demo so many times as fast as real time; 0: as fast as the machine can."""
    return Process(ROOT / 'ws', 'demo', '--real-time-factor', factor, *arguments)


def number(text, output):
    """Return the number after a text in the summary."""
    found = re.search(rf'{text} +(-?[0-9.]+)', output)
    assert found, f'no {text!r} in:\n{output}'
    return float(found.group(1))


def test_the_demo_drives_two_metres_and_leaves_a_picture():
    """Exit status 0, both distances as in the README at each factor but one, a bag and a PNG."""
    run = demo(factor=20)
    assert run.wait(90.0) == 0, run.output
    assert number('moved distance', run.stdout) == number('true distance', run.stdout) == 2.005
    assert re.search('^.* of 2.00 m', run.stdout, re.MULTILINE), 'no progress in plain lines'
    picture = re.search(r'picture +(.*)', run.stdout).group(1)
    with open(picture, 'rb') as file:
        assert file.read(4) == PNG
    with rosbag.Bag(picture.replace('run.png', 'run.bag')) as bag:
        topics = set(bag.get_type_and_topic_info().topics)
    assert topics == {'/odom', '/base_pose_ground_truth', '/moved_distance', '/cmd_vel'}


def test_the_demo_takes_a_distance_and_a_speed():
    """Backwards too, however it is written; in lockstep the machine's pace is not in the distance."""
    run = demo('--distance', '0.3', '--speed', '-2e-1', factor=100)
    assert run.wait(90.0) == 0, run.output
    assert number('moved distance', run.stdout) == number('true distance', run.stdout) == 0.311


def test_the_demo_turns_to_a_heading():
    """./ws demo rotate --target."""
    run = demo('rotate', '--target', '-135')
    assert run.wait(90.0) == 0, run.output
    assert number('heading', run.stdout) == pytest.approx(-135, abs=0.1)


def test_the_progress_is_one_live_line_on_a_terminal():
    """It is rewritten in place, and ends as a full bar; how often, test_show says."""
    reader, terminal = pty.openpty()
    with subprocess.Popen([ROOT / 'ws', 'demo', '--distance', '0.15', '--speed', '0.05',
                           '--real-time-factor', '3'],
                          stdout=terminal, stderr=terminal) as run:
        os.close(terminal)
        output = read_all(reader)
    assert run.returncode == 0, output
    assert re.search(r'\r\x1b\[K\[={30}\] 0\.15 of 0\.15 m, [^\r]*\r\n', output), output


def read_all(descriptor):
    """Return what is written to a terminal until everybody has closed it."""
    chunks = []
    try:
        while chunk := os.read(descriptor, 4096):
            chunks.append(chunk)
    except OSError:
        pass  # Linux's way to say that nobody is there any more
    os.close(descriptor)
    return b''.join(chunks).decode()


def test_a_bad_option_gets_one_clear_line():
    """And exit status 2, before anything is started; unit/test_demo_options.py has the others."""
    run = demo('--speed', '0')
    assert run.wait(30.0) == 2
    assert run.stdout == ''
    assert run.stderr.splitlines()[-1].startswith('./ws demo: error: argument --speed')
