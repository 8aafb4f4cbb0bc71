"""How long the robot drives on after it has arrived: in lockstep, beside the same graph unpaced."""

from contextlib import closing

from graph import LOCKSTEP, UNPACED, Graph
from measuring import Target, in_turns
from odometry_tests.waiting import Recorder, wait_until
from std_msgs.msg import Float64
from worlds import SPEED, stop_after

NAME, UNIT, TARGET = 'control delay in lockstep', 'simulated ms', Target('=', 0)
DISTANCE = 2.0  # m
REST_MESSAGES = 20  # with the same distance
TIMEOUT = 60.0  # s of wall time


def measure(options):
    ideal = _distance_after_arrival(stop_after(DISTANCE))  # while it brakes

    def delay(arguments):
        return 1e3 * (_distance_after_arrival(_drive(arguments)) - ideal) / SPEED

    return in_turns(options, lambda: delay(LOCKSTEP), lambda: delay(UNPACED))


def _drive(arguments):
    """Drive two metres and return the moved distances (m), the last ones at rest."""
    with Graph(*arguments, distance=DISTANCE) as graph, \
            closing(Recorder('/moved_distance', Float64)) as moved:
        moved.wait_for_publisher()
        with graph.running():
            wait_until(lambda: _is_at_rest(moved.messages), TIMEOUT, 'a robot that has arrived')
        return [message.data for message in moved.messages]


def _is_at_rest(moved):
    return len(moved) > REST_MESSAGES and DISTANCE <= moved[-1].data == moved[-REST_MESSAGES].data


def _distance_after_arrival(moved):
    return moved[-1] - next(distance for distance in moved if distance >= DISTANCE)
