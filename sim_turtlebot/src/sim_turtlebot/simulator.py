"""The simulation in ROS: topics, services and pacing around the robots and their world.

How /odom is made: _advance() steps the Simulation to the next tick, at which each Robot updates its
sensors and its odometry; then SimulationTopics publishes them.

The main thread serves the requests of rospy's threads between two ticks.
"""

import math

import rospy
from odometry_common.parameters import ParameterError, StartError
from odometry_common.publisher_conflicts import warn_of_conflicts
from odometry_common.signals import LONGEST_WAIT
from std_srvs.srv import Trigger

from sim_turtlebot.inputs import Inputs
from sim_turtlebot.pacing import Pacer
from sim_turtlebot.physics.world import NoScreenError
from sim_turtlebot.physics.world_file import WorldFileError, left_out
from sim_turtlebot.reports import Reports
from sim_turtlebot.requests import RequestQueue
from sim_turtlebot.settings import read_seed, read_settings
from sim_turtlebot.simulation import Simulation
from sim_turtlebot.simulation_topics import SimulationTopics

MIN_SLEEP = 0.001  # s; shorter sleeps take longer than requested
MAX_ROUNDS = 10  # of service calls in one tick of lockstep, by callers that call again at once
GRAPH_PERIOD = 0.1  # s of wall time between two checks whether the graph is stable


def simulate():
    """Read the parameters and simulate until shutdown."""
    settings = read_settings()
    try:
        simulation = Simulation(settings)
    except NoScreenError as error:
        raise ParameterError('~gui', True, f'false: {error}') from None
    except WorldFileError as error:
        raise ParameterError('~world', settings.world, error) from None
    Simulator(simulation, settings).run()


class Simulator:
    """Advances a Simulation, paced by the wall clock, or by the nodes in lockstep."""

    def __init__(self, simulation, settings):
        self._settings, self._simulation = settings, simulation
        self._timeline = simulation.timeline
        self._paused = settings.paused
        self._begun = self._stopping = False  # begun: time zero has been published
        self._requests = RequestQueue()
        rospy.on_shutdown(self._stop)
        self._lockstep = None
        if settings.lockstep:  # its import takes a tenth of the start
            try:
                from sim_turtlebot.lockstep.lockstep import STABLE_TIME, Lockstep
            except ModuleNotFoundError as error:
                raise StartError(f'lockstep needs {error.name}: install python3-{error.name}') from None
            self._lockstep = Lockstep(lambda: self._stopping, 1 / settings.clock_rate, settings.cpu_budget)
            # The caller has waited for the nodes.
            self._stable_time = 0.0 if settings.paused else STABLE_TIME
        numbers = range(1, settings.robots + 1)
        self._namespaces = [f'robot_{number}/' for number in numbers] if settings.robots > 1 else ['']
        self._topics = SimulationTopics(simulation, settings, self._namespaces)
        self._reports = Reports(simulation.robots, self._namespaces, settings, self._topics.warn)
        self._pacer = Pacer(settings.real_time_factor, self._reports.pace)
        self._inputs = Inputs(simulation, self._namespaces, self._requests, self._topics.warn)
        self._inputs.obeys = not self._lockstep
        self._warn_of_models_left_out()
        if settings.use_sim_time:
            warn_of_conflicts('/clock', 'stop all but one; for two robots use robots:=2')
        self._inputs.serve('~pause_physics', self._pause)
        self._inputs.serve('~unpause_physics', self._unpause)
        self._inputs.serve('~reset_simulation', self._reset, prepare=lambda: [read_seed()])
        self._inputs.serve('~step', self._step, Trigger)

    def run(self):
        """Simulate until shutdown."""
        namespaces = dict.fromkeys([self._namespaces[0], self._namespaces[-1]])
        odometry, commands = (' to '.join(rospy.resolve_name(namespace + topic) for namespace in namespaces)
                              for topic in ('odom', 'cmd_vel'))
        rospy.loginfo(f'TurtleBot 2 ready: {odometry} at {self._timeline.odom_rate:g} Hz, listening on {commands}')
        while not (self._stopping or rospy.is_shutdown()):
            self._take_turn()

    def _warn_of_models_left_out(self):
        if warning := left_out(self._settings.world):
            rospy.logwarn(warning)
            self._topics.warn('world', warning)

    def _take_turn(self):
        """Serve the waiting requests, and advance if a tick is due, even if more requests arrive."""
        if self._paused:
            self._requests.wait(LONGEST_WAIT)
            self._requests.serve_all()
            if self._inputs.poses_are_set():
                self._publish_robots()
        elif not self._begun:
            self._begin()
        else:
            lead = self._pacer.lead(self._timeline.now)
            is_early = lead > MIN_SLEEP
            if self._requests.wait(min(lead, LONGEST_WAIT) if is_early else 0.0):
                self._wait_and_serve()
            if not is_early:
                self._advance()

    def _wait_and_serve(self):
        if self._lockstep:
            self._lockstep.check_senders(self._requests.nodes, self._timeline.now / 1e9, unprompted=True)
            self._lockstep.wait()
        self._serve()

    def _serve(self):
        """Serve the waiting requests; in lockstep also the calls that follow an answer."""
        for _ in range(MAX_ROUNDS if self._lockstep else 1):
            if not self._requests.serve_all(by_name=bool(self._lockstep)):
                break
            if self._lockstep:
                self._lockstep.wait()

    def _begin(self):
        """Start time; in lockstep, once the graph is stable."""
        if self._lockstep and not self._lockstep.is_graph_stable(self._stable_time):
            if self._requests.wait(GRAPH_PERIOD):
                self._requests.serve_all()
        else:
            self._start_time()

    def _start_time(self):
        self._begun = self._inputs.obeys = True
        self._publish()
        if self._lockstep:
            self._serve()
        self._pacer.restart(self._timeline.now)

    def _advance(self):
        """Simulate to the next tick of the clock, and publish what is due."""
        # Paced by the wall clock, apply commands at the next step.
        is_paced = self._settings.real_time_factor and not self._lockstep
        new_odometry = self._simulation.advance(self._timeline.steps + 1 if is_paced else math.inf)
        unprompted = self._requests.nodes
        self._publish(new_odometry)
        if self._lockstep:
            now = self._timeline.now / 1e9
            self._lockstep.check_senders(unprompted, now, unprompted=True)
            self._lockstep.check_senders(self._requests.nodes - unprompted, now, unprompted=False)
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
        for publish in reversed(due) if self._lockstep else due:
            publish()
            if self._lockstep:
                self._lockstep.wait(only_clock=publish == self._topics.publish_clock)

    def _publish_robots(self):
        self._topics.publish_robots()
        self._reports.robots()

    def _pause(self):
        self._paused = True

    def _unpause(self):
        if self._paused:
            self._paused = False
            self._pacer.restart(self._timeline.now)

    def _step(self):
        """Advance to the next odometry while paused; return success, and its stamp (s) or why not."""
        if not self._paused:
            return False, 'call ~pause_physics first'
        # In lockstep, requests are served in between; these would move the time of this step.
        with self._requests.holding(*map(rospy.resolve_name, ('~step', '~reset_simulation'))):
            self._advance_to_odometry()
        return True, f'{self._timeline.now / 1e9:.9f}'

    def _advance_to_odometry(self):
        if self._lockstep:
            self._lockstep.wait()  # until the commands that were sent before are here
            self._serve()
        count = self._timeline.odometry_count
        if not self._begun:
            self._start_time()
        else:
            while self._timeline.odometry_count == count:
                self._advance()

    def _reset(self, seed):
        """Reset time and robots to the start, with this seed.

        While time stands still, it begins anew with the next step, as in a new simulator: nodes that
        start after the reset receive the messages of time zero.
        """
        self._simulation.reset(seed)
        self._pacer.restart(self._timeline.now)
        self._publish()
        if self._lockstep:
            self._lockstep.forget_reports()
            if self._paused:
                self._begun = self._inputs.obeys = False

    def _stop(self):
        self._stopping = True
        self._requests.put('', '', lambda: None)  # wakes the main thread
