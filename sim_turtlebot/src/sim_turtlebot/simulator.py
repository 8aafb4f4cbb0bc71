"""The simulation in ROS: topics, services and pacing around the robots and their world.

How /odom is made: _advance() steps the Simulation to the next tick, at which each Robot updates its
sensors and its odometry; then SimulationTopics publishes them.

The main thread serves the requests of rospy's threads between two ticks.
"""

import math

import rospy
from odometry_common.node import LONGEST_WAIT
from odometry_common.parameters import ParameterError

from sim_turtlebot.falls import FallDetector
from sim_turtlebot.inputs import Inputs
from sim_turtlebot.pacing import Pacer
from sim_turtlebot.physics.window import NoScreenError
from sim_turtlebot.physics.world_file import WorldFileError
from sim_turtlebot.requests import RequestQueue
from sim_turtlebot.settings import read_settings
from sim_turtlebot.simulation import Simulation
from sim_turtlebot.simulation_topics import SimulationTopics

MIN_SLEEP = 0.001  # s; shorter sleeps take longer than requested
TIMEOUT_LINE_PERIOD = 10.0  # s of wall time
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
        self._pacer = Pacer(settings.real_time_factor, self._report_pace)
        self._paused = settings.paused
        self._begun = self._stopping = False  # begun: time zero has been published
        self._requests = RequestQueue()
        rospy.on_shutdown(self._stop)
        self._lockstep = None
        if settings.lockstep:  # its import takes a tenth of the start
            from sim_turtlebot.lockstep.lockstep import STABLE_TIME, Lockstep
            self._lockstep = Lockstep(lambda: self._stopping, 1 / settings.clock_rate)
            # Whoever unpauses it knows that all nodes are there.
            self._stable_time = 0.0 if settings.paused else STABLE_TIME
        numbers = range(1, settings.robots + 1)
        self._namespaces = [f'robot_{number}/' for number in numbers] if settings.robots > 1 else ['']
        self._topics = SimulationTopics(simulation, settings, self._namespaces)
        self._falls = FallDetector(simulation.robots)
        self._inputs = Inputs(simulation, self._namespaces, self._requests, self._topics.warn)
        self._inputs.obeys = not self._lockstep
        for name, action in (('~pause_physics', self._pause), ('~unpause_physics', self._unpause),
                             ('~reset_simulation', self._reset)):
            self._inputs.serve(name, action)

    def run(self):
        """Simulate until shutdown, or until the window is closed."""
        namespaces = dict.fromkeys([self._namespaces[0], self._namespaces[-1]])
        odometry, commands = (' to '.join(rospy.resolve_name(namespace + topic) for namespace in namespaces)
                              for topic in ('odom', 'cmd_vel'))
        rospy.loginfo(f'TurtleBot 2 ready: {odometry} at {self._timeline.odom_rate:g} Hz, listening on {commands}')
        while not (self._stopping or rospy.is_shutdown()):
            self._take_turn()

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
        """Publish time zero; in lockstep, once the graph is stable."""
        if self._lockstep and not self._lockstep.is_graph_stable(self._stable_time):
            if self._requests.wait(GRAPH_PERIOD):
                self._requests.serve_all()
            return
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
            self._update_window()

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
        self._report_timeouts()
        for name, warning in self._falls.changes():
            log = rospy.logwarn if warning else rospy.loginfo
            log(warning or f'{name} stands upright again')
            self._topics.warn(name, warning)

    def _report_timeouts(self):
        """Log which robots' watchdogs have stopped them, as a Kobuki's driver does."""
        for robot, namespace in zip(self._simulation.robots, self._namespaces):
            if robot.timed_out:
                robot.timed_out = False
                rospy.logwarn_throttle(TIMEOUT_LINE_PERIOD, (
                    f'the base stops: no command on {rospy.resolve_name(namespace + "cmd_vel")} for '
                    f'{self._settings.cmd_vel_timeout:g} s (~cmd_vel_timeout)'))

    def _update_window(self):
        if self._simulation.world.window.closed:
            rospy.loginfo('the window has been closed')
            self._stop()
        else:
            self._simulation.world.look_at(self._simulation.robots[0].body)

    def _report_pace(self, reached):
        """Report on the log and on ~warning that the simulation is too slow, or has caught up."""
        wanted, warning = f'{self._settings.real_time_factor:g}', ''
        if reached is None:
            rospy.loginfo(f'the simulation keeps pace again: real-time factor {wanted}')
        else:
            warning = f'the simulation is too slow: it reaches a real-time factor of {reached:.2g} instead of {wanted}'
            rospy.logwarn(warning)
        self._topics.warn('pace', warning)

    def _pause(self):
        self._paused = True

    def _unpause(self):
        self._paused = False
        self._pacer.restart(self._timeline.now)

    def _reset(self):
        """Reset time and robots to the start."""
        self._simulation.reset()
        self._pacer.restart(self._timeline.now)
        self._publish()

    def _stop(self):
        self._stopping = True
        self._requests.put(('', ''), lambda: None)
