"""In lockstep a run as fast as the machine can has no control delay, and two are the same bytes."""

import signal

import pytest
import rospy
from geometry_msgs.msg import Twist
from lockstep_runs import (
    NOT_AWAITED,
    UNPACED,
    assert_same_bytes,
    bytes_of,
    record,
)
from nav_msgs.msg import Odometry
from odometry_tests.robots import Placer
from odometry_tests.scripts import ROOT
from odometry_tests.tutorial import (
    Truth,
    detector,
    forget_parameters,
    mover,
    rotator,
    simulator_in_step,
)
from odometry_tests.waiting import Recorder
from sensor_msgs.msg import Imu, JointState, LaserScan
from std_msgs.msg import Float64

TWO_METRES, SHORT = 24, 5  # s of simulated time


@pytest.fixture(scope='module', autouse=True)
def simulated_clock(master):
    """Let the nodes follow the simulator's clock."""
    rospy.set_param('/use_sim_time', True)


@pytest.fixture(autouse=True)
def defaults():
    """Leave no parameter to the next test."""
    yield
    forget_parameters()


def put_elsewhere():
    """Put the robot at another place, and look to another side."""
    truth = Truth()
    placer = Placer()
    truth.wait_for_publisher()  # while time stands still, the robot is shown there once
    placer.put(1.5, -2.0, yaw=2.0)
    truth.wait_for(lambda m: m.pose.pose.position.x == 1.5, what='a robot at x 1.5 m')


MOVE = [detector, mover], {
    '/odom': (Odometry, 20 * TWO_METRES), '/moved_distance': (Float64, 20 * TWO_METRES),
    '/cmd_vel': (Twist, 20 * TWO_METRES)}
SENSORS = (
    [detector, mover],
    {'/odom': (Odometry, 20 * SHORT),
     '/scan': (LaserScan, 10 * SHORT),
     '/mobile_base/sensors/imu_data': (Imu, 20 * SHORT),
     '/joint_states': (JointState, 20 * SHORT)},
    ['_scan:=true', '_scan_noise:=0.01', f'_world:={ROOT}/sim_turtlebot/worlds/room.urdf',
     '_x:=-1.0'])
ELSEWHERE = [detector, mover], {'/odom': (Odometry, 20 * SHORT)}, (), put_elsewhere
ROTATE = [rotator], {'/odom': (Odometry, 20 * SHORT), '/cmd_vel': (Twist, 10 * SHORT)}


@pytest.fixture(scope='module')
def two_metres():
    """Record a drive of two metres."""
    return record(*MOVE)


@pytest.mark.parametrize('tutorial', [
    pytest.param(MOVE, marks=pytest.mark.nightly), pytest.param(ELSEWHERE, marks=pytest.mark.nightly), ROTATE, SENSORS],
                         ids=['move', 'elsewhere', 'rotate', 'sensors'])
def test_two_runs_are_the_same_bytes(two_metres, tutorial):
    """Each message on each topic, from the first to the last."""
    first = two_metres if tutorial is MOVE else record(*tutorial)
    assert_same_bytes(first, record(*tutorial))


def test_the_zero_command_comes_at_the_odometry_that_reaches_two_metres(two_metres):
    """No control delay: the robot brakes from the very odometry on that has seen two metres."""
    odometry = two_metres['/odom']
    arrived = next(m for m in odometry if m.pose.pose.position.x >= 2.0)
    following = next(m for m in odometry if m.header.seq == arrived.header.seq + 1)
    assert following.twist.twist.linear.x < 0.05, 'still driving one period later'
    assert 2.0 <= two_metres['/moved_distance'][-1].data <= 2.006


def test_a_mover_that_is_killed_does_not_stop_the_time():
    """Nor does it have to be named."""
    with simulator_in_step(UNPACED) as simulation, detector(), mover() as driver:
        odometry = Recorder('odom', Odometry)
        odometry.wait_for(lambda m: m.header.stamp.to_sec() > 1, 20.0, 'a running simulation')
        driver.send(signal.SIGKILL)
        driver.wait()
        silent_from = odometry.last.header.stamp.to_sec()
        odometry.wait_for(lambda m: m.header.stamp.to_sec() > silent_from + 10, 20.0,
                          'ten seconds more')
        assert odometry.last.twist.twist.linear.x == 0.0
    assert NOT_AWAITED not in simulation.output


@pytest.mark.nightly
def test_two_clocks_lead_to_the_same_odometry():
    """However finely the clock ticks: the same bytes."""
    coarse, fine = (record([detector, mover], {'/odom': (Odometry, 40)}, clock)
                    for clock in ([], ['_clock_rate:=170']))
    assert [bytes_of(m) for m in coarse['/odom']] == [bytes_of(m) for m in fine['/odom']]
