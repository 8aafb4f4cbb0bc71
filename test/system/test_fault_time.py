"""Time that stops, goes back, crawls, races and jumps."""

import subprocess
import sys
import time
from pathlib import Path

import pytest
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from odometry_tests.pausing import call, pause
from odometry_tests.processes import Process, rosrun
from odometry_tests.tutorial import (
    LONGEST_STEP,
    OVERSHOOT,
    Distance,
    Truth,
    detector,
    mover,
    simulator_in_step,
)
from odometry_tests.waiting import Recorder, wait_for_subscribers, wait_until
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Empty

pytestmark = pytest.mark.usefixtures('simulated_time')


def x(recorder):
    """Return how far ahead (m) a robot was seen last."""
    return recorder.last.pose.pose.position.x


@pytest.mark.parametrize('factor, distance', [(0.05, 0.01), (100, 0.5)])
def test_the_robot_arrives_at_any_speed_of_time(master, factor, distance):
    moved, truth = Distance(), Truth()
    with simulator_in_step(f'_real_time_factor:={factor}'), detector(), \
            mover(f'_distance:={distance}') as driver:
        moved.wait_for(lambda m: m.data >= distance, what='the distance')
        truth.wait_until_resting()
        assert 'stopping' not in driver.output
    assert moved.last.data < distance + OVERSHOOT


def test_neither_a_pause_nor_a_reset_is_movement_and_every_node_survives_them(master):
    """In mid-drive all stands; odometry starts from zero; time and robot go back to zero."""
    moved, truth, clock = Distance(), Truth(), Recorder('/clock', Clock)
    odometry = Recorder('odom', Odometry)
    reset = rospy.Publisher('mobile_base/commands/reset_odometry', Empty, queue_size=1)
    with simulator_in_step('_real_time_factor:=10'), detector() as counter, \
            mover('_distance:=0.6') as driver, rosrun('rotate_robot', 'main.py') as printer:
        wait_for_subscribers(reset)
        moved.wait_for(lambda m: m.data > 0.3, what='0.3 m')  # a jump is more than 0.25 m
        pause(moved, truth, clock)
        odometry.clear()
        reset.publish(Empty())
        call('unpause_physics')
        odometry.wait_for(lambda m: m.pose.pose.position.x < 0.05, what='odometry near zero')
        counter.wait_for_output('not counted')
        moved.wait_for(lambda m: m.data > 0.45, what='0.45 m')
        pause(moved, truth)
        before = moved.last.data
        assert x(truth) == pytest.approx(before, abs=LONGEST_STEP)
        call('reset_simulation')
        call('unpause_physics')
        arrived = moved.wait_until_arrived(0.6)
        assert arrived < 0.6 + OVERSHOOT
        assert x(truth) == pytest.approx(arrived - before, abs=LONGEST_STEP)
        assert all(process.running for process in (counter, driver, printer))
    assert min(moved.steps) >= 0 and max(moved.steps) < LONGEST_STEP


@pytest.fixture
def jumping_clock(tmp_path):
    """Build a wall clock for processes, and a file whose number of seconds it is ahead."""
    library, jump = tmp_path / 'jumping_clock.so', tmp_path / 'jump'
    jump.write_text('0')
    source = Path(__file__).with_name('jumping_clock.c')
    subprocess.run(['g++', '-x', 'c', '-shared', '-fPIC', '-o', library, source], check=True)
    return jump, {'env': {'LD_PRELOAD': str(library), 'CLOCK_JUMP': str(jump)}}


def wall_clock(options):
    """Return what time it is (s) to a process that is started with these options."""
    with Process(sys.executable, '-c', 'import time; print(time.time())', **options) as process:
        assert process.wait() == 0, process.output
    return float(process.stdout)


def test_the_wall_clock_may_jump(master, jumping_clock):
    """In simulated time nobody feels it: a day forward, then a day back, in mid-drive."""
    jump, fake = jumping_clock
    moved, commands = Distance(), Recorder('cmd_vel', Twist)
    with simulator_in_step('_real_time_factor:=10', **fake), detector(**fake), \
            mover('_distance:=0.3', **fake) as driver:
        moved.wait_for(lambda m: m.data > 0.1, what='0.1 m')
        jump.write_text('86400')
        assert wall_clock(fake) > time.time() + 80000
        moved.wait_for(lambda m: m.data > 0.2, what='0.2 m')
        jump.write_text('-86400')
        assert moved.wait_until_arrived(0.3) < 0.3 + OVERSHOOT
        wait_until(lambda: commands.last == Twist(), 10.0, 'a zero command')
    assert 'stopping' not in driver.output
