"""./ws demo, from its first line to the picture it leaves, beside another demo."""

import contextlib
import os
import re
from pathlib import Path

from odometry_tests.forms import number_after
from odometry_tests.processes import run
from odometry_tests.scripts import ROOT
from odometry_tools.runs.ports import HeldPort


def test_it_drives_two_metres_and_leaves_a_picture():
    """In lockstep the distances are the same at each pace; beside another demo it says where its master is."""
    with contextlib.closing(HeldPort(0)) as port:
        demo = run(ROOT / 'ws', 'demo', '--real-time-factor', '0', timeout=90.0,
                   env={'ROS_MASTER_URI': f'http://localhost:{port.number}'})
    own_port = re.search(r'^rostopic in another terminal: export ROS_MASTER_URI=.*:(\d+)$', demo.stdout,
                         re.MULTILINE).group(1)
    assert int(own_port) != port.number
    assert number_after('moved distance', demo.stdout) == 2.005
    assert number_after('true distance', demo.stdout) == 2.005
    picture = re.search(r'picture +(.*)', demo.stdout).group(1)
    assert Path(picture).resolve().parents[1] == Path(os.environ['ODOMETRY_RUNS'])
    assert Path(picture).read_bytes().startswith(b'\x89PNG')
