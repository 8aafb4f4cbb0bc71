"""The steps of the soak: act, command, receive, check."""

import signal
from collections import Counter

from checks import DistanceCheck, PoseCheck, Violation
from course import KILL, PAUSE, PERIOD, RESET_DISTANCE, RESET_ODOMETRY, RESET_SIMULATION, RESTART
from usage import FEWEST, Usage, growing

USAGE_PERIOD = 200  # steps between two measurements of memory, threads and files
WARM_UP_SHARE = 0.25  # of the run, before the first of them
LONGEST_WARM_UP = 12000  # steps, ten simulated minutes
STAMP_TOLERANCE = 1e-6  # s


class Driver:
    """The controller of a simulation in lockstep.

    After each step the simulation stands until this program waits for the next one: everything that
    belongs to the step has come by then, and whatever it does meanwhile is done between two steps.
    """

    def __init__(self, nodes, steps):
        """Drive these nodes; so many steps are intended."""
        self._nodes = nodes
        self._warm_up = min(LONGEST_WARM_UP, WARM_UP_SHARE * steps)
        self._distance = DistanceCheck()
        self._pose = PoseCheck()
        self._number = 0
        self._actions = {
            RESET_DISTANCE: self._reset_distance, RESET_ODOMETRY: self._reset_odometry,
            RESET_SIMULATION: lambda: self._nodes.call('reset_simulation'),
            PAUSE: lambda: self._nodes.call('pause_physics'),
            RESTART: lambda: self._restart(signal.SIGINT),
            KILL: lambda: self._restart(signal.SIGKILL)}
        self.usage = {}  # Usages by the name of the process
        self.events = Counter({name: 0 for name in self._actions})
        self.steps = 0
        self.metres = 0.0

    @property
    def seconds(self):
        """Simulated time so far (s), not counting from its resets."""
        return self.steps * PERIOD

    def step(self, linear, angular, event):
        """Do what is due, let the simulation go on to the next odometry, and check it.

        :param linear, angular: velocity to command (m/s, rad/s)
        :param event: what else to do; None: nothing
        """
        paused = self.steps == 0
        if event:
            self._actions[event]()
            self.events[event] += 1
            paused = event in (PAUSE, RESTART, KILL)
        if event == RESET_SIMULATION:
            # It sends its first odometry without a command.
            self._number = 0
            self._pose.start()
        elif self.steps:
            self._number += 1
            self._nodes.command(linear, angular)
        if paused:
            self._nodes.odometry.check_silence()
            self._nodes.call('unpause_physics')
        self._check()

    def _check(self):
        """Take the messages of this step and check them."""
        odometry, truth = self._next(self._nodes.odometry), self._next(self._nodes.truth)
        distance = self._nodes.distance.next().data
        self._distance.check(odometry, distance)
        self._pose.check(odometry, truth)
        if self.steps >= self._warm_up and self.steps % USAGE_PERIOD == 0:
            self._measure()
        self.steps += 1
        self.metres += abs(truth.twist.twist.linear.x) * PERIOD

    def _measure(self):
        for name, pid in self._nodes.pids.items():
            measured = self.usage.setdefault(name, [])
            measured.append(Usage.of(pid))
            names = growing(measured) if len(measured) % FEWEST == 0 else []
            if names:
                raise Violation(f'the {" and ".join(names)} of {name} grow: {measured[0]}, then '
                                f'{measured[-1]}')

    def _next(self, stream):
        """Return the message of this step."""
        message = stream.next()
        number, stamp = message.header.seq, message.header.stamp.to_sec()
        expected = self._number * PERIOD
        if number != self._number or abs(stamp - expected) > STAMP_TOLERANCE:
            raise Violation(f'odometry or truth {number} at {stamp} s came instead of '
                            f'{self._number} at {expected:.3f} s')
        return message

    def _reset_distance(self):
        self._nodes.reset_distance.publish()
        self._distance.reset()

    def _reset_odometry(self):
        self._nodes.reset_odometry.publish()
        self._pose.reset()

    def _restart(self, signum):
        self._nodes.call('pause_physics')
        self._nodes.restart_detector(signum)
        self._distance = DistanceCheck()
