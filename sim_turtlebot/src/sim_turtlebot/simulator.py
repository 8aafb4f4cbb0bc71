"""The simulation in ROS: topics, services and pacing around the robots and their world.

ROS calls back on threads of its own. They leave requests, which the main thread serves between two
advances of the simulation. A command for which time has waited is obeyed, and time goes on, on the
command's own thread, while the main thread lends its turn.
"""

import math
import time

import rospy
from odometry_common.ending import LONGEST_WAIT, quiet_at_shutdown
from std_srvs.srv import Empty, EmptyResponse

from sim_turtlebot.current_warnings import CurrentWarnings
from sim_turtlebot.falls import Falls
from sim_turtlebot.lockstep import Lockstep
from sim_turtlebot.pacing import Pacer
from sim_turtlebot.poses import checked_pose
from sim_turtlebot.request_queue import RequestQueue
from sim_turtlebot.simulation_topics import SimulationTopics, namespaces

SHORTEST_SLEEP = 0.001  # s; a shorter one would oversleep
REPEAT_PERIOD = 0.1  # s of wall time between two odometries while no controller has spoken
REMIND_PERIOD = 2.0  # s of wall time between two lines that say so
NAMED = 4  # topics in such a line; more would not be read
LATE_SHARE = 0.25  # of ~lockstep_patience without an answer: no late one will come


class Simulator:
    """Lets time pass in a Simulation, as the clock and the controllers allow."""

    def __init__(self, simulation, settings):
        """Advertise; time starts with run()."""
        self._settings = settings
        self._simulation = simulation
        self._timeline = simulation.timeline
        self._pacer = Pacer(settings.real_time_factor, self._report_pace)
        self._lockstep = None
        if settings.lockstep_rate:
            self._lockstep = Lockstep(
                settings.lockstep_rate, self._timeline.step_rate, settings.robots)
        # Whether a command may be an answer to an earlier odometry than the latest.
        self._may_be_late = False
        self._reminded = time.monotonic()
        self._paused = settings.paused
        self._begun = False  # whether time zero has been published
        self._stopping = False
        self._requests = RequestQueue()
        rospy.on_shutdown(self._stop)
        self._topics = SimulationTopics(simulation, settings)
        self._warnings = CurrentWarnings(self._topics.warn)
        self._falls = Falls(simulation.robots, self._report_fall)
        self._listen()

    def run(self):
        """Simulate until shutdown, or until the window is closed."""
        if not self._paused:  # else nobody may listen yet
            self._publish()
        self._pacer.restart(self._timeline.now)
        while not (self._stopping or rospy.is_shutdown()):
            self._take_turn()

    def _take_turn(self):
        """Serve one request if there is one, else advance if it is time to."""
        if not self._requests.empty() or self._paused:
            self._requests.serve(LONGEST_WAIT)
        elif self._lockstep and self._may_be_late and self._lockstep.started:
            self._wait_for_late_answers()
        elif self._lockstep and self._lockstep.must_wait(self._timeline.steps):
            self._wait_for_controllers()
        else:
            lead = self._pacer.lead(self._timeline.now)
            if lead > SHORTEST_SLEEP:
                self._requests.serve(min(lead, LONGEST_WAIT))
            else:
                self._advance()

    def _wait_for_controllers(self):
        if not self._lockstep.started:
            self._wait_for_first_command()
            return
        patience = self._settings.lockstep_patience
        self._silent_since = time.monotonic()
        while (left := self._silent_since + patience - time.monotonic()) > 0:
            if self._requests.lend_turn(min(left, LONGEST_WAIT)):
                return
        if self._lockstep.give_up():
            rospy.logwarn(f'lockstep: no command for {patience:g} s of wall time; going on '
                          'without waiting until there is one')

    def _go_on(self):
        """Advance from a command for which time has waited to the next one."""
        while not self._lockstep.must_wait(self._timeline.steps):
            if self._stopping or self._pacer.lead(self._timeline.now) > SHORTEST_SLEEP:
                self._requests.put(lambda: None)  # which is the main thread's business
                return
            self._advance()
        self._silent_since = time.monotonic()

    def _wait_for_first_command(self):
        """Repeat the odometry while there is no command."""
        if not self._requests.serve(REPEAT_PERIOD):
            self._may_be_late = True
            self._topics.repeat()
            self._remind()

    def _wait_for_late_answers(self):
        """Serve the answers to earlier odometries that are still to come.

        They must not be taken for answers to the next one. Nothing in a Twist tells them
        apart; so wait until no more come.
        """
        patience = self._settings.lockstep_patience
        end = time.monotonic() + patience
        while not self._stopping and time.monotonic() < end:
            if not self._requests.serve(LATE_SHARE * patience):
                break
        self._may_be_late = False

    def _remind(self):
        """Say from time to time what is waited for: a client cannot see why its sleep has no end."""
        if time.monotonic() - self._reminded < REMIND_PERIOD:
            return
        self._reminded = time.monotonic()
        topics = self._topics.command_topics
        more = f', ... ({len(topics)} topics)' if len(topics) > NAMED else ''
        rospy.logwarn('lockstep: time stands still until there is a first command on '
                      f'{", ".join(topics[:NAMED])}{more}')

    def _last_step(self):
        """Return the step at which the wall clock or the controllers matter again."""
        if self._settings.real_time_factor:
            return self._timeline.steps + 1
        return self._lockstep.last_step if self._lockstep else math.inf

    def _advance(self):
        """Let time pass, and publish what is due then."""
        new_odometry = self._simulation.advance(self._last_step())
        if self._timeline.clock_is_due:
            self._topics.publish_clock()
        if new_odometry:
            self._publish_robots()
            if self._settings.gui:
                self._update_window()

    def _publish(self):
        self._begun = True
        self._topics.publish_clock()
        self._publish_robots()

    def _publish_robots(self):
        self._topics.publish_robots()
        self._falls.look()

    def _update_window(self):
        if self._simulation.world.window.closed:
            rospy.loginfo('the window has been closed')
            self._stop()
        else:
            self._simulation.world.look_at(self._simulation.robots[0].body)

    def _listen(self):
        robots, put = self._simulation.robots, self._requests.put
        self._topics.subscribe(self._on_command,
                               lambda index: put(robots[index].reset_odometry),
                               lambda *pose: put(lambda: self._set_pose(*pose)))
        for name, action in (('~pause_physics', self._pause), ('~unpause_physics', self._unpause),
                             ('~reset_simulation', self._reset)):
            rospy.Service(name, Empty, lambda _, action=action: self._answer(action))

    def _answer(self, action):
        try:
            self._requests.put_and_wait(action)
        except TimeoutError as error:
            raise rospy.ServiceException(error) from None
        return EmptyResponse()

    def _on_command(self, *command):
        with quiet_at_shutdown():
            self._requests.serve_if_lent(lambda: self._command(*command), self._go_on)

    def _command(self, index, linear, angular, mux_input):
        # A command that the multiplexer does not pass on is its controller's answer too.
        if self._lockstep:
            self._lockstep.heard(index)
        try:
            self._simulation.command(linear, angular, index, mux_input)
        except ValueError as error:
            rospy.logwarn_throttle(1.0, f'stopping: {error}')

    def _set_pose(self, index, *pose):
        """Put a robot elsewhere; while time stands still, show it there."""
        try:
            self._simulation.robots[index].set_pose(*checked_pose(*pose))
        except ValueError as error:
            namespace = namespaces(self._settings.robots)[index]
            rospy.logwarn_throttle(1.0, f'~{namespace}set_pose refused: {error}')
            return
        if self._paused:
            self._publish_robots()
            self._may_be_late = True

    def _report_fall(self, name, text):
        """Warn, in the log and for the page, of a robot on its side, or take that back."""
        if text:
            rospy.logwarn(text)
        else:
            rospy.loginfo(f'{name} stands upright again')
        self._warnings.set(name, text)

    def _report_pace(self, reached):
        """Warn, in the log and for the page, that the machine is too slow, or has caught up."""
        wanted = self._settings.real_time_factor
        if reached is None:
            text = ''
            rospy.loginfo(f'the simulation keeps pace again: real-time factor {wanted:g}')
        else:
            text = (f'this machine is too slow: it reaches a real-time factor of {reached:.2g} '
                    f'instead of {wanted:g}')
            rospy.logwarn(f'{text}; fewer robots, a lower ~odom_rate or ~real_time_factor help')
        self._warnings.set('pace', text)

    def _pause(self):
        self._paused = True

    def _unpause(self):
        self._paused = False
        if not self._begun:
            self._publish()
        self._pacer.restart(self._timeline.now)

    def _reset(self):
        """Take time and robots back to the start."""
        if self._lockstep:
            self._may_be_late |= self._lockstep.is_owed_an_answer(self._timeline.steps)
            self._lockstep.restart()
        self._simulation.reset()
        self._pacer.restart(self._timeline.now)
        self._publish()

    def _stop(self):
        self._stopping = True
        self._requests.put(lambda: None)
