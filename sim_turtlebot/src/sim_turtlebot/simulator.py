"""The simulation in ROS: topics, services and pacing around the robots and their world.

How /odom is made: _advance() steps the Simulation to the next tick, at which each Robot updates its
sensors and its odometry; then SimulationTopics publishes them.

The main thread serves the requests of rospy's threads between two ticks.
"""

import math

import rospy
from odometry_common.parameters import ParameterError
from odometry_common.publisher_conflicts import warn_of_conflicts
from odometry_common.signals import LONGEST_WAIT
from std_srvs.srv import Trigger

from sim_turtlebot.inputs import Inputs
from sim_turtlebot.pacing import Pacer
from sim_turtlebot.physics.world_file import WorldFileError, left_out
from sim_turtlebot.reports import Reports
from sim_turtlebot.requests import RequestQueue
from sim_turtlebot.settings import read_seed, read_settings
from sim_turtlebot.simulation import Simulation
from sim_turtlebot.simulation_topics import SimulationTopics
from sim_turtlebot.synchronising import synchronise

MIN_SLEEP = 0.001  # s; shorter sleeps take longer than requested
MAX_ROUNDS = 10  # of service calls in one tick of lockstep, by callers that call again at once
GRAPH_PERIOD = 0.1  # s of wall time between two checks whether the graph is stable


def simulate():
    """Read the parameters and simulate until shutdown."""
    settings = read_settings()
    try:
        simulation = Simulation(settings)
    except WorldFileError as error:
        raise ParameterError('~world', settings.world, error) from None
    Simulator(simulation, settings).run()


class Simulator:
    """Advances a Simulation, paced by the wall clock, or by the nodes in lockstep."""

    def __init__(self, simulation, settings):
        self._settings, self._simulation = settings, simulation
        self._timeline = simulation.timeline
        self._paused = settings.paused
        self._begun = False  # whether time zero has been published
        self._requests = RequestQueue()
        self._nodes = synchronise(settings)
        self._topics = SimulationTopics(simulation, settings)
        self._reports = Reports(simulation.robots, settings)
        self._pacer = Pacer(settings.real_time_factor, self._reports.pace)
        self._inputs = Inputs(simulation.robots, self._requests, self._reports.warn)
        self._inputs.obeys = not settings.lockstep
        if warning := left_out(settings.world):
            rospy.logwarn(warning)
            self._reports.warn('world', warning)
        if settings.use_sim_time:
            warn_of_conflicts('/clock', 'stop all but one; for two robots use robots:=2')
        self._inputs.serve('~pause_physics', self._pause)
        self._inputs.serve('~unpause_physics', self._unpause)
        self._inputs.serve('~reset_simulation', self._reset, prepare=lambda: [read_seed()])
        self._inputs.serve('~step', self._step, Trigger)

    def run(self):
        """Simulate until shutdown."""
        rospy.loginfo(
            f'TurtleBot 2 ready: {self._names_of("odom")} at {self._timeline.odom_rate:g} Hz, '
            f'listening on {self._names_of("cmd_vel")}')
        while not rospy.core.is_shutdown_requested():
            self._take_turn()

    def _names_of(self, topic):
        """Return the first and the last robot's name of a topic, or the only one's."""
        names = [rospy.resolve_name(robot.namespace + topic)
                 for robot in self._simulation.robots]
        return names[0] if len(names) == 1 else f'{names[0]} to {names[-1]}'

    def _take_turn(self):
        """Serve the waiting requests; advance if a tick is due, even if more requests arrive."""
        if self._paused:
            if self._inputs.pose_is_set:
                self._publish_robots()
            self._requests.wait(LONGEST_WAIT)
            self._requests.serve_all(by_name=self._settings.lockstep)
        elif not self._begun:
            self._begin()
        else:
            lead = self._pacer.lead(self._timeline.now)
            is_early = lead > MIN_SLEEP
            if self._requests.wait(min(lead, LONGEST_WAIT) if is_early else 0.0):
                self._check_senders(self._requests.arrivals)
                self._nodes.wait()
                self._serve()
            if not (is_early or self._paused):
                self._advance()

    def _check_senders(self, unprompted):
        self._nodes.check_senders({**self._requests.arrivals, **unprompted},
                                  self._timeline.now / 1e9, unprompted)

    def _serve(self):
        """Serve the waiting requests, and the calls that follow an answer."""
        for _ in range(MAX_ROUNDS):
            if not self._requests.serve_all(by_name=self._settings.lockstep):
                break
            self._nodes.wait()

    def _begin(self):
        """Start time; in lockstep, once the graph is stable."""
        if self._settings.paused:  # the caller of ~unpause_physics has waited for the nodes
            is_stable = self._nodes.is_graph_stable(0.0)
        else:
            is_stable = self._nodes.is_graph_stable()
        if is_stable:
            self._start_time()
        elif self._requests.wait(GRAPH_PERIOD):
            self._requests.serve_all()

    def _start_time(self):
        self._begun = self._inputs.obeys = True
        self._publish()
        self._serve()
        self._pacer.restart(self._timeline.now)

    def _advance(self):
        """Simulate to the next tick of the clock, and publish what is due."""
        # Paced by the wall clock, apply commands at the next step.
        is_paced = self._settings.real_time_factor and not self._settings.lockstep
        new_odometry = self._simulation.advance(self._timeline.steps + 1 if is_paced else math.inf)
        unprompted = self._requests.arrivals
        self._publish(new_odometry)
        self._check_senders(unprompted)
        self._serve()
        if new_odometry and self._settings.gui:
            self._simulation.world.look_at(self._simulation.robots[0].body)

    def _publish(self, new_odometry=True):
        """Publish what is due; in lockstep, wait after each until all nodes are idle.

        Lockstep publishes the odometry first, so that a loop has it when the clock wakes the loop.
        """
        due = [self._topics.publish_clock] if self._timeline.clock_is_due else []
        if new_odometry:
            due.append(self._publish_robots)
        for publish in reversed(due) if self._settings.lockstep else due:
            publish()
            self._nodes.wait(only_clock=publish == self._topics.publish_clock)

    def _publish_robots(self):
        self._inputs.pose_is_set = False
        self._topics.publish_robots()
        self._reports.robots()

    def _pause(self):
        self._paused = True

    def _unpause(self):
        if self._paused:
            self._paused = False
            self._pacer.restart(self._timeline.now)

    def _step(self):
        """Advance to the next odometry while paused; return success, and stamp (s) or why not."""
        if not self._paused:
            return False, 'call ~pause_physics first'
        self._nodes.wait()  # until the commands that were sent before are here
        self._serve()
        if self._inputs.pose_is_set:
            self._publish_robots()
            self._nodes.wait()
            self._serve()
        count = self._timeline.odometry_count
        if not self._begun:
            self._start_time()
        else:
            while self._timeline.odometry_count == count:
                self._advance()
        return True, f'{self._timeline.now / 1e9:.9f}'

    def _reset(self, seed):
        """Reset time and robots to the start, with this seed.

        While time stands still, it begins anew with the next step, as in a new simulator: nodes
        that start after the reset receive the messages of time zero.
        """
        self._simulation.reset(seed)
        self._pacer.restart(self._timeline.now)
        self._publish()
        self._nodes.forget_reports()
        if self._settings.lockstep and self._paused:
            self._begun = self._inputs.obeys = False
