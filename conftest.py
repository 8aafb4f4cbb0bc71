"""A ROS master for each run of pytest, and for each of its workers: rospy joins one only once."""

import itertools
import os
import signal
import sys

import pytest

try:
    from odometry_tests.rostests import join
except ImportError:
    sys.exit('the tests need ROS and the built packages: type ./ws test, or ./ws shell first')
import rosgraph
import rospy
from odometry_tests.forked import Forked
from odometry_tests.fuzzing import load_profile
from odometry_tests.processes import Master, started
from odometry_tests.tutorial import forget_parameters
from odometry_tests.waiting import open_recorders
from rospy.impl.registration import Registration

NAMESPACES = (f'case_{number}' for number in itertools.count(1))
# A run that a script starts in the background ignores Ctrl-C, which the tests press.
signal.signal(signal.SIGINT, signal.default_int_handler)
pytest_plugins = ['odometry_tests.pytest_run', 'odometry_tests.rostest_items']

load_profile()


@pytest.fixture(scope='session')
def joined_master():
    """Start a ROS master, join it as a node, and yield both it and how to reach it."""
    before = dict(os.environ)
    with Master(start=Forked) as process:
        if not rospy.core.is_initialized():
            join('system_test', anonymous=True, disable_signals=True, disable_rostime=True)
        variables = {name: os.environ[name] for name in ('ROS_MASTER_URI', 'ROS_HOSTNAME')}
        restore(before)
        yield process, variables


@pytest.fixture(scope='module', autouse=True)
def own_variables():
    """Give each file the environment that pytest was started with."""
    before = dict(os.environ)
    yield
    restore(before)


def restore(environment):
    """Make this the environment again."""
    os.environ.clear()
    os.environ.update(environment)


@pytest.fixture(scope='module')
def master(joined_master):
    """Give each file a master without parameters, in wall time, to which only this node is known."""
    process, variables = joined_master
    os.environ.update(variables)
    parameters = rosgraph.Master('/test')
    for name in parameters.getParamNames():
        parameters.deleteParam(name)
    parameters.setParam('/use_sim_time', False)
    yield process
    leave_topics()


def leave_topics():
    """Publish and receive nothing more: the next file's robot would have a stranger about it."""
    topics = rospy.topics.get_topic_manager()
    for kind, known in (Registration.PUB, topics.pubs), (Registration.SUB, topics.subs):
        for name in {*known} - {'/rosout'}:
            while name in known:
                topics.release_impl(kind, name)


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
