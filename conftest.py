"""A ROS master for each run of pytest: rospy joins one only once."""

import itertools
import os

import pytest
import rospy
from odometry_tests.forked import Forked
from odometry_tests.fuzzing import load_profile
from odometry_tests.processes import Master, started
from odometry_tests.rostests import join
from odometry_tests.tutorial import forget_parameters
from odometry_tests.waiting import open_recorders

NAMESPACES = (f'case_{number}' for number in itertools.count(1))

load_profile()


@pytest.fixture(scope='session')
def master():
    """Start a master of its own, with the clock of the wall, and join it as a node."""
    with Master(start=Forked) as process:
        if not rospy.core.is_initialized():
            join('system_test', anonymous=True, disable_signals=True, disable_rostime=True)
        yield process


@pytest.fixture(scope='session', autouse=True)
def runs(tmp_path_factory):
    """Have demos, sweeps and benches leave their folders here, and nothing in the checkout."""
    os.environ['ODOMETRY_RUNS'] = str(tmp_path_factory.mktemp('runs', numbered=False))


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(item):
    """Let a test that fails say what each process that it started has printed."""
    report = (yield).get_result()
    if report.failed:
        report.sections += [(f'{process.command} {process.state}', process.output)
                            for process in started]
    if report.when == 'teardown':
        started.clear()


@pytest.fixture(autouse=True)
def recorders_of_its_own():
    """Have no test hear what an earlier one's robot has said: on a busy machine that comes late."""
    earlier = len(open_recorders)
    yield
    for recorder in open_recorders[earlier:]:
        recorder.close()
    del open_recorders[earlier:]


@pytest.fixture
def simulated_time(master):
    """Let the nodes follow the simulator's clock, with the parameters of this test only."""
    forget_parameters()
    rospy.set_param('/use_sim_time', True)


@pytest.fixture
def ns(master, monkeypatch):
    """Give the nodes of a test a namespace of their own, without connections of an earlier test."""
    name = next(NAMESPACES)
    monkeypatch.setenv('ROS_NAMESPACE', name)
    return f'/{name}/'
