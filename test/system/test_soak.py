"""The soak passes a simulated minute, and finds what is wrong."""

import os
import re
import subprocess

from odometry_tests.linux import assert_loopback_only, marked, new_mark, wait_until_none
from odometry_tests.processes import Process
from odometry_tests.scripts import ROOT

SOAK = ROOT / 'test' / 'soak' / 'run_soak.py'
A_MINUTE = 0.017  # hours; in the first minute of any course each event comes once
STEPS = 1224  # of a 20th of a second in that time
TIMEOUT = 180.0  # s
EVENTS = ['resets of the distance', 'resets of the odometry', 'resets of the simulation',
          'pauses', 'restarts of the detector', 'kills of the detector']


def soak(*arguments):
    return Process('python3', SOAK, *arguments)


def value_of(name, soaked):
    """Return what the summary says behind a name."""
    found = re.search(rf'^{name}: +(.*)$', soaked.stdout, re.MULTILINE)
    assert found, soaked.output
    return found.group(1)


def master_of(soaking):
    """Return the address of a soak's ROS master, once its robot drives."""
    soaking.wait_for_output('ROS_MASTER_URI=', 60.0)
    return {'ROS_MASTER_URI': soaking.stdout.partition('ROS_MASTER_URI=')[2].split()[0]}


def test_a_simulated_minute_passes_with_every_event():
    """Exit status 0, and a summary of what was done and found."""
    with soak('--hours', A_MINUTE, '--seed', 3) as soaked:
        assert soaked.wait(TIMEOUT) == 0, soaked.output
    assert value_of('simulated time', soaked) == '0:01:01'
    assert value_of('steps checked', soaked) == str(STEPS)
    assert [value_of(event, soaked) for event in EVENTS] == ['1'] * len(EVENTS)
    assert value_of('violations', soaked) == '0'
    assert float(value_of('driven', soaked).split()[0]) > 1.0
    for node in ('simulator', 'detector', 'rosmaster', 'rosout', 'this program'):
        assert re.match(r'[\d.]+ MB, .* -> [\d.]+ MB, ', value_of(f'usage of {node}', soaked))
    assert 'replay' not in soaked.output


def test_a_wrong_distance_is_found_and_the_run_can_be_repeated():
    """A second publisher lies; the step is named, the exit status is 1."""
    with soak('--hours', 24, '--seed', 4) as soaking, \
            Process('rostopic', 'pub', '-1', '/moved_distance', 'std_msgs/Float64', '1234.5',
                    env=master_of(soaking)):
        assert soaking.wait(TIMEOUT) == 1, soaking.output
    assert value_of('violations', soaking) == '1'
    assert re.search(r'^violation at step \d+: /moved_distance is 1234\.5, and the sum of the '
                     r'steps is \d', soaking.stdout, re.MULTILINE), soaking.output
    assert soaking.stdout.endswith('replay: ./ws soak --seed 4 --hours 24')


def test_nothing_is_left_of_a_soak_that_is_killed():
    """By kill -9, which it cannot notice itself."""
    mark = new_mark()
    with subprocess.Popen([ROOT / 'ws', 'soak'], env={**os.environ, **mark},
                          stdout=subprocess.PIPE, text=True) as soaking:
        assert 'ROS_MASTER_URI=' in soaking.stdout.readline()
        assert len(marked(mark)) > 4
        assert_loopback_only(soaking.pid)
        soaking.kill()
    wait_until_none(mark)
