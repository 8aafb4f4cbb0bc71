"""Stop conditions of a scenario, and the route that the check drives."""

import math
import time

from odometry_tools.check.scenarios import ROUTE

PATIENCE = 15.0  # simulated s for a node to begin
WALL_PATIENCE = 3.0  # s of wall time for a node, which may sleep, to begin or to go on
REST_TIME = 7.0  # s; a node may rest five seconds between two parts of its drive
REST_STEP = 1e-4  # m + rad between two odometries
LIMIT = 120.0  # s of driving
FARTHEST = 5.0  # m
MOST_TURNS = 3 * 2 * math.pi  # rad
MOST_SWINGS = 60  # changes of direction; a controller that settles makes a few
INTERRUPT_AFTER = 0.5  # m or rad
LEG_REST = 2.6  # s; a detector that counts every two seconds does so while the robot rests


class Drive:
    """Stop condition for a node that drives: the robot rests, or has gone much too far."""

    def __init__(self, wall_patience=WALL_PATIENCE, target=None):
        """Take how long a node may sleep before it begins (s), and a heading (degrees) or None."""
        self._wall_patience, self._target = wall_patience, target
        self._active = None  # s
        self._commands = self._swings = 0  # commands seen, and their changes of direction
        self._turning = 0.0  # rad/s, at the latest swing

    def is_over(self, run):
        """Return whether a Run is over at its latest odometry."""
        if run.first_move is None:
            return not _may_begin(run, self._wall_patience)
        if not math.isfinite(run.commands[-1].linear + run.commands[-1].angular):
            return True
        pose = run.odometry[-1]
        if (run.scenario.interrupt and run.is_driving
                and max(pose.way, abs(pose.turn)) > INTERRUPT_AFTER):
            return True
        # Its speed would not do: a node may stop whenever odometry is due, and drive in between.
        before = run.odometry[-2:][0]
        step = pose.way - before.way + pose.turned - before.turned
        if step > REST_STEP or run.commands[-1].moves and (
                pose.time - run.commands[-1].time < REST_TIME
                or run.status is None and time.monotonic() - run.latest < WALL_PATIENCE):
            self._active = pose.time
        return (pose.time - max(self._active or 0.0, run.first_move) > REST_TIME
                or pose.time - run.first_move > LIMIT or pose.way > FARTHEST
                or self._target is not None and (
                    abs(pose.turn) > MOST_TURNS or self._count_swings(run) > MOST_SWINGS))

    def _count_swings(self, run):
        """Return how often the commands have changed direction, noise aside."""
        for command in run.commands[self._commands:]:
            if command.swings:
                self._swings += command.angular * self._turning < 0
                self._turning = command.angular
        self._commands = len(run.commands)
        return self._swings


class Route:
    """Drives the route, leg by leg, once the node has published, or no longer may begin to."""

    def __init__(self, drive, wall_patience=WALL_PATIENCE):
        """Take what commands a linear (m/s) and an angular speed (rad/s); patience as in Drive."""
        self._drive, self._wall_patience, self._start = drive, wall_patience, None

    def is_over(self, run):
        """Send the next command of the route; return whether the route is over."""
        if self._start is None:
            if not run.moved and _may_begin(run, self._wall_patience):
                return False
            self._start, begin = run.now, run.now + LEG_REST
            for leg in ROUTE:
                run.legs.append((leg.name, begin, begin := begin + leg.duration + LEG_REST))
        for leg, (_, begin, end) in zip(ROUTE, run.legs):
            if run.now < end - 1e-6:
                is_driven = begin - 1e-6 < run.now < begin + leg.duration - 1e-6
                self._drive(*(leg.linear, leg.angular) if is_driven else (0.0, 0.0))
                return False
        return True


def _may_begin(run, wall_patience):
    """Return whether a node that has sent nothing may still begin: it may sleep by wall time."""
    return run.now <= PATIENCE or run.status is None and run.wall_time() < wall_patience
