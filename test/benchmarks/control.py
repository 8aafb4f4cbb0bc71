"""How late the robot hears that it has arrived, and how far it goes on."""

from contextlib import closing

from graph import Graph
from lockstep import LOCKSTEP
from measuring import Target, compare
from odometry_tests.waiting import Recorder, wait_until
from speed import UNPACED
from std_msgs.msg import Float64
from worlds import SPEED, stop_after

DISTANCE = 2.0  # m
REST_MESSAGES = 20  # with the same distance
TIMEOUT = 60.0  # s of wall time


def control_unpaced(options):
    """Measure delay and overshoot as fast as the graph can."""
    yield from _control(options, 'unpaced', UNPACED, None, None)


def control_in_lockstep(options):
    """Measure delay and overshoot where the robot waits for each command."""
    yield from _control(options, 'in lockstep', LOCKSTEP, Target('=', 0, of_value=True),
                        Target('<=', 6, of_value=True))


def _control(options, name, arguments, delay_target, overshoot_target):
    """Return delay and overshoot, each against a controller without any delay."""
    ideal = stop_after(DISTANCE)
    runs = [_drive(arguments) for _ in range(options.runs)]
    yield compare(f'control delay {name}', 'simulated ms',
                  [(_delay(run, ideal), 0.0) for run in runs], delay_target)
    yield compare(f'overshoot {name}', 'mm',
                  [(_overshoot(run), _overshoot(ideal)) for run in runs], overshoot_target)


def _drive(arguments):
    """Drive two metres and return the moved distances (m), the last ones at rest."""
    with Graph(*arguments, distance=DISTANCE) as graph, \
            closing(Recorder('/moved_distance', Float64)) as moved:
        moved.wait_for_publisher()
        with graph.running():
            wait_until(lambda: _rests(moved.messages), TIMEOUT, 'a robot that has arrived')
        return [message.data for message in moved.messages]


def _rests(moved):
    return len(moved) > REST_MESSAGES and DISTANCE <= moved[-1].data == moved[-REST_MESSAGES].data


def _overshoot(moved):
    """Return how far the robot went too far (mm)."""
    return 1e3 * (moved[-1] - DISTANCE)


def _delay(moved, ideal):
    """Return the time (simulated ms) that the robot drove on after its arrival.

    A robot without delay still rolls on for a bit while it brakes.
    """
    return 1e3 * (_distance_after_arrival(moved) - _distance_after_arrival(ideal)) / SPEED


def _distance_after_arrival(moved):
    return moved[-1] - next(distance for distance in moved if distance >= DISTANCE)
