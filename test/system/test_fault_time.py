"""Time that stops, goes back, crawls, races and jumps."""

import signal
import subprocess
from pathlib import Path

import pytest
import rosgraph
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from odometry_tests.processes import rosrun
from odometry_tests.tutorial import (
    REST_SPEED,
    Truth,
    detector,
    mover,
    rotator,
    simulator,
    speed,
)
from odometry_tests.waiting import Recorder, wait_until
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Empty as EmptyMessage
from std_msgs.msg import Float64
from std_srvs.srv import Empty


@pytest.fixture(autouse=True)
def simulated_time(master):
    """Let the nodes follow the simulator's clock."""
    rosgraph.Master('/test').setParam('/use_sim_time', True)


def call(service):
    """Call a service of the simulator."""
    name = f'/sim_turtlebot/{service}'
    rospy.wait_for_service(name, 10.0)
    rospy.ServiceProxy(name, Empty)()


def wait_until_time_stands(clock):
    """Return once two looks, seconds of simulated time apart, see the same time."""
    looks = []

    def stands():
        looks.append(clock.last.clock)
        return looks.count(looks[-1]) > 1

    wait_until(stands, 5.0, lambda: f'time that stands, but it was {looks}', period=0.5)


@pytest.mark.parametrize('factor', [0.05, 1, 100])
def test_the_robot_arrives_at_any_speed_of_time(master, factor):
    """The detector and the mover need no particular pace; slowly, a hand's breadth is enough."""
    distance = 0.02 if factor < 1 else 0.3
    moved = Recorder('moved_distance', Float64)
    with simulator(f'_real_time_factor:={factor}'), detector(), \
            mover(f'_distance:={distance}', '_exit_when_done:=true') as driver:
        moved.wait_for(lambda m: m.data >= distance, 60.0, 'the distance')
        assert driver.wait(60.0) == 0, driver.output
    # At 100 times real time a reaction of 5 ms is half a second of driving.
    assert moved.last.data < distance + (0.1 if factor > 1 else 0.012)


def test_a_pause_stops_time_and_nothing_is_lost(master):
    """Paused in mid-drive, everything stands; afterwards the robot drives on to its goal."""
    moved = Recorder('moved_distance', Float64)
    clock = Recorder('/clock', Clock)
    with simulator('_real_time_factor:=5'), detector(), mover('_distance:=1') as driver:
        moved.wait_for(lambda m: m.data > 0.3, 20.0, '0.3 m')
        call('pause_physics')
        wait_until_time_stands(clock)
        call('unpause_physics')
        moved.wait_for(lambda m: m.data >= 1.0, 20.0, 'the goal')
        assert driver.running
    steps = [b.data - a.data for a, b in zip(moved.messages, moved.messages[1:])]
    assert max(steps) < 0.01, 'the pause shows in the distance'


@pytest.mark.parametrize('start', [mover, rotator])
@pytest.mark.parametrize('signum', [signal.SIGINT, signal.SIGTERM])
def test_a_node_ends_while_time_stands_still(master, start, signum):
    """No sleep on a paused clock keeps it; the robot gets its zero before time goes on."""
    with simulator('_real_time_factor:=5', '_cmd_vel_timeout:=0'), detector():
        truth = Truth()
        with start() as node:
            truth.wait_until_moving()
            call('pause_physics')
            assert node.end(signum, timeout=5.0) == 0, node.output
            assert 'Traceback' not in node.output
        call('unpause_physics')
        stamp = truth.stamp
        truth.wait_for(lambda m: m.header.stamp.to_sec() > stamp + 0.35
                       and speed(m) < REST_SPEED, what='a robot at rest at once')


def test_a_reset_is_no_movement_and_every_node_survives_it(master):
    """Time and robot go back to zero in mid-drive; the mover drives the rest."""
    moved = Recorder('moved_distance', Float64)
    with simulator('_real_time_factor:=5'), detector() as counter, mover('_distance:=1') as driver, \
            rosrun('rotate_robot', 'main.py') as printer:
        truth = Truth()
        moved.wait_for(lambda m: m.data > 0.5, 20.0, '0.5 m')
        call('reset_simulation')
        truth.wait_for(lambda m: m.header.stamp.to_sec() < 1, what='time near zero')
        moved.wait_for(lambda m: m.data >= 1.0, 20.0, 'the goal')
        truth.wait_until_resting()
        assert 0.3 < truth.last.pose.pose.position.x < 0.6, 'the other half of the way'
        assert all(process.running for process in (counter, driver, printer))
    steps = [b.data - a.data for a, b in zip(moved.messages, moved.messages[1:])]
    assert -1e-12 <= min(steps) and max(steps) < 0.01


def test_rotate_turns_to_its_target_after_a_reset(master):
    """Its rate and its watchdog begin anew when time goes back."""
    with simulator('_real_time_factor:=5'), rotator() as controller:
        truth = Truth()
        truth.wait_for(lambda m: m.header.stamp.to_sec() > 5, 20.0, 'five seconds')
        call('reset_simulation')
        odometry = Recorder('odom', Odometry)
        odometry.wait_for(lambda m: m.pose.pose.orientation.z > 0.7, 20.0, 'nearly 90 degrees')
        assert controller.running
    assert 'Traceback' not in controller.output


def test_a_reset_of_the_odometry_is_no_movement(master):
    """The robot stays where it is, odom begins at zero, and the detector does not count it."""
    moved = Recorder('moved_distance', Float64)
    with simulator('_real_time_factor:=5'), detector() as counter, mover('_distance:=1'):
        truth, odometry = Truth(), Recorder('odom', Odometry)
        reset = rospy.Publisher('mobile_base/commands/reset_odometry', EmptyMessage, queue_size=1)
        moved.wait_for(lambda m: m.data > 0.5, 20.0, '0.5 m')
        reset.publish(EmptyMessage())
        odometry.clear()
        odometry.wait_for(lambda m: m.pose.pose.position.x < 0.1, what='odometry near zero')
        moved.wait_for(lambda m: m.data >= 0.9, 20.0, 'most of the way')
        counter.wait_for_output('not counted')
        truth.wait_until_resting()
    assert truth.last.pose.pose.position.x == pytest.approx(moved.last.data, abs=0.02)


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
    moved, commands = Recorder('moved_distance', Float64), Recorder('cmd_vel', Twist)
    with simulator('_real_time_factor:=5', env=fake), detector(env=fake), \
            mover('_distance:=1', env=fake) as driver:
        moved.wait_for(lambda m: m.data > 0.3, 30.0, '0.3 m')
        jump.write_text('86400')
        moved.wait_for(lambda m: m.data > 0.6, 30.0, '0.6 m')
        jump.write_text('-86400')
        moved.wait_for(lambda m: m.data >= 1.0, 30.0, 'the goal')
        wait_until(lambda: commands.last.linear.x == 0, 10.0, 'a zero command')
    assert 'stopping' not in driver.output
    assert moved.last.data < 1.02
