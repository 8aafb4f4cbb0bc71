"""In lockstep a run as fast as the machine can has no control delay, and two are the same bytes."""

import contextlib
import signal
import sys
import threading
from concurrent.futures import ThreadPoolExecutor

import pytest
import rospy
from geometry_msgs.msg import Twist
from lockstep_runs import NOT_AWAITED, RUN_TIME, UNPACED, assert_same_bytes, record
from nav_msgs.msg import Odometry
from odometry_tests.pausing import call
from odometry_tests.processes import Process
from odometry_tests.scripts import ROOT
from odometry_tests.tutorial import detector, mover, rotator, simulator, simulator_in_step
from odometry_tests.waiting import Recorder
from sensor_msgs.msg import Imu, JointState, LaserScan
from std_srvs.srv import Trigger

SHORT = 5  # s of simulated time

pytestmark = pytest.mark.usefixtures('simulated_time')

SENSORS = (
    [detector, mover],
    {'/odom': (Odometry, 20 * SHORT),
     '/scan': (LaserScan, 10 * SHORT),
     '/mobile_base/sensors/imu_data': (Imu, 20 * SHORT),
     '/joint_states': (JointState, 20 * SHORT)},
    ['_scan:=true', '_scan_noise:=0.01', f'_world:={ROOT}/sim_turtlebot/worlds/room.urdf',
     '_x:=-1.0'])
ROTATE = [rotator], {'/odom': (Odometry, 20 * SHORT), '/cmd_vel': (Twist, 10 * SHORT)}


def test_two_runs_are_the_same_bytes():
    assert_same_bytes(*(record(*SENSORS) for _ in range(2)))


def first_second():
    """Start the tutorial's graph, all nodes at once; return its odometry and commands from time zero on."""
    with contextlib.ExitStack() as stack:
        recorders = {topic: stack.enter_context(contextlib.closing(Recorder(topic, kind)))
                     for topic, kind in (('/odom', Odometry), ('/cmd_vel', Twist))}
        # Named as by roslaunch: time does not begin while such a process has yet to register.
        for start, *arguments in ((simulator_in_step, UNPACED, '__name:=sim_turtlebot'),
                                  (detector, '__name:=detector'), (mover, '__name:=mover')):
            stack.enter_context(start(*arguments))
        messages = {topic: recorder.wait_for_count(20, RUN_TIME) for topic, recorder in recorders.items()}
    assert messages['/odom'][0].header.stamp.to_sec() == 0.0
    return messages


@pytest.mark.parametrize('starts', [2, pytest.param(200, marks=pytest.mark.nightly)])
def test_the_first_second_is_the_same_at_each_start_of_a_busy_machine(starts):
    """Although nothing waits for the nodes before time begins."""
    with contextlib.ExitStack() as stack:
        for _ in range(4):
            stack.enter_context(Process(sys.executable, '-c', 'while True: pass'))
        first = first_second()
        for _ in range(starts - 1):
            assert_same_bytes(first, first_second())


def test_steps_from_outside_move_the_robot_as_lockstep_does_by_itself():
    """To the byte, and each answers with the stamp of the odometry that it has published."""
    stamps = []

    def step_by_step():
        step = rospy.ServiceProxy('/sim_turtlebot/step', Trigger)
        stamps.extend(step().message for _ in range(20 * SHORT))

    stepped = record(*ROTATE, begin=step_by_step)
    assert_same_bytes(record(*ROTATE), stepped)
    assert stamps == [f'{message.header.stamp.to_sec():.9f}' for message in stepped['/odom']]


def step(count):
    with contextlib.closing(rospy.ServiceProxy('/sim_turtlebot/step', Trigger, persistent=True)) as proxy:
        return [proxy() for _ in range(count)]


@pytest.fixture
def stepped_simulator():
    with simulator(UNPACED, '_lockstep:=true', '_paused:=true'):
        for service in 'step', 'reset_simulation':
            rospy.wait_for_service(f'/sim_turtlebot/{service}')
        yield


def test_each_of_several_callers_steps_a_period_of_its_own(stepped_simulator):
    with ThreadPoolExecutor() as pool:
        answers = [answer for answers in pool.map(step, [50, 50]) for answer in answers]
    assert len({answer.message for answer in answers}) == 100
    assert max(float(answer.message) for answer in answers) == pytest.approx(99 * 0.05)


def test_a_step_succeeds_beside_resets(stepped_simulator):
    done = threading.Event()

    def reset():
        while not done.is_set():
            call('reset_simulation')

    with ThreadPoolExecutor() as pool:
        resets = pool.submit(reset)
        try:
            assert all(answer.success for answer in step(50))
        finally:
            done.set()
        resets.result()


def test_only_a_paused_simulation_can_be_stepped():
    with simulator_in_step():
        rospy.wait_for_service('/sim_turtlebot/step')
        answer = rospy.ServiceProxy('/sim_turtlebot/step', Trigger)()
    assert (answer.success, answer.message) == (False, 'call ~pause_physics first')


def test_a_mover_that_is_killed_does_not_stop_the_time():
    with simulator_in_step(UNPACED) as simulation, detector(), \
            mover('_distance:=100') as driver:
        odometry = Recorder('odom', Odometry)
        odometry.wait_for(lambda m: m.twist.twist.linear.x > 0.05, 20.0, 'a moving robot')
        driver.send(signal.SIGKILL)
        driver.wait()
        silent_from = odometry.last.header.stamp.to_sec()
        odometry.wait_for(lambda m: m.header.stamp.to_sec() > silent_from + 10, 20.0,
                          'ten seconds more')
        assert odometry.last.twist.twist.linear.x == 0.0
        assert 'the base stops: no command on /cmd_vel for 0.6 s' in simulation.output
    assert NOT_AWAITED not in simulation.output
