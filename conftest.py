"""A ROS master for each file of tests, at one address: rospy learns that only once."""

import itertools
import os
import signal
import sys
import uuid
from unittest import mock

import pytest

try:
    from odometry_tests.linux import MARK
except ImportError:
    sys.exit('the tests need ROS and the built packages: type ./ws test, or ./ws shell first')
import rospy
from odometry_common.rospy_fixes import fix_rospy
from odometry_common.transport import wait_for_slow_subscribers
from odometry_tests.partners import SteppedClock
from odometry_tests.processes import Master, hold_port, own_address, started
from odometry_tests.tutorial import forget_parameters
from odometry_tests.waiting import PATIENCE, TIMEOUT, open_recorders
from rospy.impl.registration import Registration

NAMESPACES = (f'case_{number}' for number in itertools.count(1))
# A run that a script starts in the background, or by nohup, ignores signals that the tests send.
signal.signal(signal.SIGINT, signal.default_int_handler)
signal.signal(signal.SIGHUP, signal.SIG_DFL)
pytest_plugins = [
    'odometry_tests.fuzzing', 'odometry_tests.pytest_run', 'odometry_tests.rostest_items']


@pytest.fixture(scope='session')
def master_port():
    """Hold the port of all masters of this run: rospy knows only one."""
    with hold_port(own_address()) as port:
        yield port


@pytest.fixture(scope='module', autouse=True)
def own_variables():
    """Give each file the environment that pytest was started with."""
    with mock.patch.dict(os.environ):
        yield


@pytest.fixture(scope='module')
def master(master_port, own_variables):
    """Start a master for each file, with the clock of the wall, and join it as a node."""
    with Master(port=master_port) as process:
        if not rospy.core.is_initialized():
            fix_rospy()
            wait_for_slow_subscribers(TIMEOUT * PATIENCE)  # unlike the nodes under test
            rospy.init_node(
                'system_test', anonymous=True, disable_signals=True, disable_rostime=True)
            rospy.get_param('/use_sim_time')  # rospy keeps to the master that it asks first
        yield process
        leave_topics()


def leave_topics():
    """Publish and receive nothing more, as the next master would not know of it."""
    rospy.core._client_shutdown_hooks.clear()  # the final messages of publishers that are gone then
    topics = rospy.topics.get_topic_manager()
    for kind, known in (Registration.PUB, topics.pubs), (Registration.SUB, topics.subs):
        for name in {*known} - {'/rosout'}:
            while name in known:
                topics.release_impl(kind, name)


@pytest.fixture(scope='session', autouse=True)
def runs(tmp_path_factory):
    """Have demos, sweeps and benches write into a temporary folder."""
    os.environ['ODOMETRY_RUNS'] = str(tmp_path_factory.mktemp('runs', numbered=False))


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(item):
    """Add the output of each process that a failed test started to its report."""
    report = (yield).get_result()
    if report.failed:
        report.sections += [(f'{process.command} {process.state}', process.output)
                            for process in started]
    if report.when == 'teardown':
        started.clear()


@pytest.fixture(autouse=True)
def closed_recorders():
    """Close the recorders of each test: on a busy machine earlier robots' messages arrive late."""
    earlier = len(open_recorders)
    yield
    for recorder in open_recorders[earlier:]:
        recorder.close()
    del open_recorders[earlier:]


@pytest.fixture
def mark(monkeypatch):
    """Mark the processes that this test starts, for odometry_tests.linux.marked()."""
    monkeypatch.setenv(MARK, str(uuid.uuid4()))
    return os.environ[MARK]


@pytest.fixture
def simulated_time(master):
    """Let the nodes follow the simulator's clock, with the parameters of this test only."""
    forget_parameters()
    rospy.set_param('/use_sim_time', True)


@pytest.fixture
def ns(master, monkeypatch):
    """Give each test its own namespace, so that no earlier test's node is connected."""
    name = next(NAMESPACES)
    monkeypatch.setenv('ROS_NAMESPACE', name)
    return f'/{name}/'


@pytest.fixture
def node(request, ns):
    """Start the file's node, START, in simulated time, with the arguments that a test gives."""
    rospy.set_param('/use_sim_time', True)
    with request.module.START(*getattr(request, 'param', [])) as process:
        yield process
    rospy.set_param('/use_sim_time', False)


@pytest.fixture
def clock(node):
    """Publish the clock of that node."""
    made = SteppedClock(1)
    yield made
    made.close()
