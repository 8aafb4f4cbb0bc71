"""The simulation in ROS: topics, services and pacing around the robots and their world.

ROS calls back on threads of its own. They leave requests, which the main thread serves between two
advances of the simulation; in lockstep once every node of the graph rests, in the order of their
senders' names.
"""

import math
from functools import partial

import rospy
from odometry_common.shutdown import LONGEST_WAIT
from std_srvs.srv import Empty, EmptyResponse

from sim_turtlebot.current_warnings import CurrentWarnings
from sim_turtlebot.falls import Falls
from sim_turtlebot.lockstep import Lockstep
from sim_turtlebot.pacing import Pacer
from sim_turtlebot.poses import checked_pose
from sim_turtlebot.request_queue import RequestQueue
from sim_turtlebot.robot_topics import sender_of
from sim_turtlebot.simulation_topics import SimulationTopics, namespaces

SHORTEST_SLEEP = 0.001  # s; a shorter one would oversleep
LOOK_PERIOD = 0.1  # s of wall time between two looks at a graph that is about to settle


class Simulator:
    """Lets time pass in a Simulation, as the clock and the controllers allow."""

    def __init__(self, simulation, settings):
        """Advertise; time starts with run()."""
        self._settings = settings
        self._simulation = simulation
        self._timeline = simulation.timeline
        self._pacer = Pacer(settings.real_time_factor, self._report_pace)
        self._paused = settings.paused
        self._begun = False  # whether time zero has been published
        self._stopping = False
        self._requests = RequestQueue()
        rospy.on_shutdown(self._stop)
        self._lockstep = Lockstep(lambda: self._stopping) if settings.lockstep else None
        self._topics = SimulationTopics(simulation, settings)
        self._warnings = CurrentWarnings(self._topics.warn)
        self._falls = Falls(simulation.robots, self._report_fall)
        self._listen()

    def run(self):
        """Simulate until shutdown, or until the window is closed."""
        while not (self._stopping or rospy.is_shutdown()):
            self._take_turn()

    def _take_turn(self):
        """Serve one request if there is one, else advance if it is time to."""
        if not self._requests.empty() or self._paused:
            self._serve(LONGEST_WAIT)
        elif not self._begun:
            self._begin()
        else:
            lead = self._pacer.lead(self._timeline.now)
            if lead > SHORTEST_SLEEP:
                self._serve(min(lead, LONGEST_WAIT))
            else:
                self._advance()

    def _serve(self, timeout):
        """Wait (s of wall time) for a request and serve it, in lockstep all that come with it."""
        if self._paused or not self._lockstep:
            self._requests.serve(timeout)
        elif self._requests.wait(timeout):
            self._lockstep.wait()
            self._serve_all()

    def _serve_all(self):
        if self._requests.serve_all():
            self._lockstep.wait()  # whoever was answered goes on

    def _begin(self):
        """Publish time zero; in lockstep once everybody is there."""
        if self._lockstep and not self._lockstep.has_settled():
            self._requests.wait(LOOK_PERIOD)
            return
        self._begun = True
        self._publish()
        self._pacer.restart(self._timeline.now)

    def _advance(self):
        """Let time pass, and publish what is due then."""
        # On the wall clock, a command is obeyed at the next step.
        is_paced = self._settings.real_time_factor and not self._lockstep
        new_odometry = self._simulation.advance(self._timeline.steps + 1 if is_paced else math.inf)
        self._publish(new_odometry)
        if self._lockstep:
            self._serve_all()
        if new_odometry and self._settings.gui:
            self._update_window()

    def _publish(self, new_odometry=True):
        """Publish what is due; in lockstep wait for what comes of it.

        The odometry comes first there: a loop that the clock wakes then knows it.
        """
        due = [self._topics.publish_clock] if self._timeline.clock_is_due else []
        if new_odometry:
            due.append(self._publish_robots)
        for publish in reversed(due) if self._lockstep else due:
            publish()
            if self._lockstep:
                self._lockstep.wait()

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
        self._topics.subscribe(
            lambda index, sender, *command: put((sender, partial(self._command, index, *command))),
            lambda index, sender: put((sender, robots[index].reset_odometry)),
            lambda index, sender, *pose: put((sender, partial(self._set_pose, index, *pose))))
        for name, action in (('~pause_physics', self._pause), ('~unpause_physics', self._unpause),
                             ('~reset_simulation', self._reset)):
            rospy.Service(name, Empty, partial(self._answer, action))

    def _answer(self, action, request):
        try:
            self._requests.put_and_wait(action, sender_of(request))
        except TimeoutError as error:
            raise rospy.ServiceException(error) from None
        return EmptyResponse()

    def _command(self, index, linear, angular, mux_input):
        if self._lockstep and not self._begun:
            return  # whether it arrives, or comes before the connection, is chance
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
        self._pacer.restart(self._timeline.now)

    def _reset(self):
        """Take time and robots back to the start."""
        self._simulation.reset()
        self._pacer.restart(self._timeline.now)
        self._publish()

    def _stop(self):
        self._stopping = True
        self._requests.put((('', ''), lambda: None))
