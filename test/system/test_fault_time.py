"""Time that stops, goes back, crawls, races and jumps."""

import signal
import subprocess
from pathlib import Path

import pytest
import rosgraph
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from odometry_tests.pausing import call, moves_on, pause
from odometry_tests.processes import rosrun
from odometry_tests.tutorial import (
    LONGEST_STEP,
    OVERSHOOT,
    Distance,
    Truth,
    detector,
    forget_parameters,
    heading,
    mover,
    rotator,
    simulator,
    simulator_in_step,
)
from odometry_tests.waiting import Recorder, wait_for_subscribers, wait_until
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Empty

BRAKING = 0.15  # s, from the last odometry before a zero on
TURNED = 9.2  # s, for all but a degree of 90


@pytest.fixture(autouse=True)
def simulated_time(master):
    """Let the nodes follow the simulator's clock, with the parameters of this test only."""
    forget_parameters()
    rosgraph.Master('/test').setParam('/use_sim_time', True)


def x(recorder):
    """Return how far ahead (m) a robot was seen last."""
    return recorder.last.pose.pose.position.x


@pytest.mark.parametrize('factor, distance', [(0.05, 0.01), (1, 0.1), (100, 1.0)])
def test_the_robot_arrives_at_any_speed_of_time(master, factor, distance):
    """The detector and the mover need no particular pace."""
    moved, truth = Distance(), Truth()
    with simulator_in_step(f'_real_time_factor:={factor}'), detector(), \
            mover(f'_distance:={distance}') as driver:
        moved.wait_for(lambda m: m.data >= distance, what='the distance')
        truth.wait_until_resting()
        assert 'stopping' not in driver.output
    assert moved.last.data < distance + OVERSHOOT


def test_the_robot_arrives_when_time_runs_away_from_its_controllers(master):
    """A reaction of 5 ms is half a second of driving then: it gets there, and past it."""
    moved = Distance()
    with simulator('_real_time_factor:=100'), detector(), mover('_distance:=1'):
        moved.wait_until_arrived(1.0)


def test_a_pause_stops_time_and_nothing_is_lost(master):
    """Paused in mid-drive, everything stands; afterwards the robot drives on to its goal."""
    moved, truth, clock = Distance(), Truth(), Recorder('/clock', Clock)
    with simulator_in_step('_real_time_factor:=10'), detector(), mover('_distance:=1') as driver:
        moved.wait_for(lambda m: m.data > 0.3, what='0.3 m')
        pause(moved, truth, clock)
        call('unpause_physics')
        assert moved.wait_until_arrived(1.0) < 1.0 + OVERSHOOT
        assert driver.running
    assert max(moved.steps) < LONGEST_STEP, 'the pause shows in the distance'


@pytest.mark.parametrize('start', [mover, rotator])
@pytest.mark.parametrize('signum', [signal.SIGINT, signal.SIGTERM])
def test_a_node_ends_while_time_stands_still(master, start, signum):
    """No sleep on a paused clock keeps it; the robot gets its zero before time goes on."""
    truth, commands = Truth(), Recorder('cmd_vel', Twist)
    with simulator('_real_time_factor:=5', '_cmd_vel_timeout:=0'), detector(), start() as node:
        truth.wait_until_moving()

        def end():
            assert node.end(signum) == 0, node.output
            wait_until(lambda: commands.last == Twist(), 10.0, 'zero as the last command')

        assert moves_on(truth, end) <= BRAKING
    assert 'Traceback' not in node.output


def test_a_reset_is_no_movement_and_every_node_survives_it(master):
    """Time and robot go back to zero in mid-drive; the mover drives the rest."""
    moved, truth = Distance(), Truth()
    with simulator_in_step('_real_time_factor:=10'), detector() as counter, \
            mover('_distance:=1') as driver, rosrun('rotate_robot', 'main.py') as printer:
        moved.wait_for(lambda m: m.data > 0.5, what='0.5 m')
        pause(moved, truth)
        before = moved.last.data
        call('reset_simulation')
        call('unpause_physics')
        arrived = moved.wait_until_arrived(1.0)
        assert arrived < 1.0 + OVERSHOOT
        assert x(truth) == pytest.approx(arrived - before, abs=LONGEST_STEP)
        assert all(process.running for process in (counter, driver, printer))
    assert min(moved.steps) >= 0 and max(moved.steps) < LONGEST_STEP


def test_rotate_turns_to_its_target_after_a_reset(master):
    """Its rate and its watchdog begin anew when time goes back: it does not wait for the old time."""
    truth = Truth()
    with simulator_in_step('_real_time_factor:=20', rate=10), rotator() as controller:
        truth.wait_for(lambda m: m.header.stamp.to_sec() > 5, what='five seconds')
        pause(truth)
        truth.clear()
        call('reset_simulation')
        call('unpause_physics')
        turned = truth.wait_for(lambda m: heading(m) > 89, what='nearly 90 degrees')
        assert turned.header.stamp.to_sec() < TURNED
        assert controller.running
    assert 'Traceback' not in controller.output


def test_a_reset_of_the_odometry_is_no_movement(master):
    """The robot stays where it is, odom begins at zero, and the detector does not count it."""
    moved, truth, odometry = Distance(), Truth(), Recorder('odom', Odometry)
    reset = rospy.Publisher('mobile_base/commands/reset_odometry', Empty, queue_size=1)
    with simulator_in_step('_real_time_factor:=10'), detector() as counter, mover('_distance:=1'):
        wait_for_subscribers(reset)
        moved.wait_for(lambda m: m.data > 0.5, what='0.5 m')
        odometry.clear()
        reset.publish(Empty())
        odometry.wait_for(lambda m: m.pose.pose.position.x < 0.1, what='odometry near zero')
        arrived = moved.wait_until_arrived(1.0)
        assert x(truth) == pytest.approx(arrived, abs=LONGEST_STEP)
        counter.wait_for_output('not counted')


@pytest.fixture
def jumping_clock(tmp_path):
    """Build a wall clock for processes, and a file whose number of seconds it is ahead."""
    library, jump = tmp_path / 'jumping_clock.so', tmp_path / 'jump'
    jump.write_text('0')
    source = Path(__file__).with_name('jumping_clock.c')
    subprocess.run(['g++', '-x', 'c', '-shared', '-fPIC', '-o', library, source], check=True)
    return jump, {'LD_PRELOAD': str(library), 'CLOCK_JUMP': str(jump)}


def test_the_wall_clock_may_jump(master, jumping_clock):
    """In simulated time nobody feels it: a day forward, then a day back, in mid-drive."""
    jump, fake = jumping_clock
    moved, commands = Distance(), Recorder('cmd_vel', Twist)
    with simulator_in_step('_real_time_factor:=10', env=fake), detector(env=fake), \
            mover('_distance:=1', env=fake) as driver:
        moved.wait_for(lambda m: m.data > 0.3, what='0.3 m')
        jump.write_text('86400')
        moved.wait_for(lambda m: m.data > 0.6, what='0.6 m')
        jump.write_text('-86400')
        assert moved.wait_until_arrived(1.0) < 1.0 + OVERSHOOT
        wait_until(lambda: commands.last == Twist(), 10.0, 'a zero command')
    assert 'stopping' not in driver.output
