"""In lockstep a run as fast as the machine can has no control delay, and two are the same bytes."""

import contextlib
import signal
import sys

import pytest
from geometry_msgs.msg import Twist
from lockstep_runs import NOT_AWAITED, RUN_TIME, UNPACED, assert_same_bytes, record, step
from nav_msgs.msg import Odometry
from odometry_tests.processes import Process
from odometry_tests.tutorial import Truth, detector, is_at_rest, mover, rotator, simulator_in_step
from odometry_tests.waiting import Recorder

SHORT = 5  # s of simulated time

pytestmark = pytest.mark.usefixtures('simulated_time')

ROTATE = [rotator], {'/odom': (Odometry, 20 * SHORT), '/cmd_vel': (Twist, 10 * SHORT)}


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
        stamps.extend(answer.message for answer in step(20 * SHORT))

    stepped = record(*ROTATE, begin=step_by_step)
    assert_same_bytes(record(*ROTATE), stepped)
    assert stamps == [f'{message.header.stamp.to_sec():.9f}' for message in stepped['/odom']]


def test_only_a_paused_simulation_can_be_stepped():
    with simulator_in_step():
        answer, = step(1)
    assert (answer.success, answer.message) == (False, 'call ~pause_physics first')


def test_a_mover_that_is_killed_does_not_stop_the_time():
    with simulator_in_step(UNPACED) as simulation, detector(), \
            mover('_distance:=100') as driver:
        truth = Truth()
        truth.wait_until_moving()
        driver.end(signal.SIGKILL)
        simulation.wait_for_output('the base stops: no command on /cmd_vel for 0.6 s')
        assert is_at_rest(truth.wait_seconds(10.0))
    assert NOT_AWAITED not in simulation.output
