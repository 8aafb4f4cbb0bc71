"""The simulation in ROS: topics, services and pacing around the robots and their world.

The way of /odom: advance() steps the Simulation to the next tick, in which each Robot updates its
sensors and its odometry; then SimulationTopics publishes them.

rospy's threads leave requests, which the main thread serves between two advances of the simulation;
in lockstep once every node of the graph rests, in the order of their senders' names.
"""

import math
from functools import partial

import rospy
from geometry_msgs.msg import PoseStamped, Twist
from odometry_common.node import LONGEST_WAIT
from odometry_common.parameters import ParameterError
from std_msgs.msg import Empty
from std_srvs import srv

from sim_turtlebot.falls import Falls
from sim_turtlebot.lockstep import Lockstep
from sim_turtlebot.pacing import Pacer
from sim_turtlebot.poses import checked_pose
from sim_turtlebot.request_queue import RequestQueue
from sim_turtlebot.settings import read_settings
from sim_turtlebot.simulation import Simulation
from sim_turtlebot.simulation_topics import SimulationTopics
from sim_turtlebot.velocity_mux import INPUTS
from sim_turtlebot.window import NoScreenError
from sim_turtlebot.world_file import WorldFileError

SHORTEST_SLEEP = 0.001  # s; shorter sleeps take longer than asked
BUSY_SHARE = 0.8  # of a processor; a simulation that gets less waits for others
TIMEOUT_LINE_PERIOD = 10.0  # s of wall time
MOST_ROUNDS = 10  # of answers to callers that ask again at once, in one moment of lockstep
LOOK_PERIOD = 0.1  # s of wall time between two checks whether the graph has settled


def simulate():
    """Simulate until shutdown, as the parameters say."""
    settings = read_settings()
    try:
        simulation = Simulation(settings)
    except NoScreenError as error:
        raise ParameterError('~gui', True, f'false: {error}') from None
    except WorldFileError as error:
        raise ParameterError('~world', settings.world, error) from None
    Simulator(simulation, settings).run()


class Simulator:
    """Advances a Simulation at the pace of the wall clock, or of the nodes in lockstep."""

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
        self._namespaces = [''] if settings.robots == 1 else [
            f'robot_{number}/' for number in range(1, settings.robots + 1)]
        self._topics = SimulationTopics(simulation, settings, self._namespaces)
        self._falls = Falls(simulation.robots)
        self._listen()

    def run(self):
        """Simulate until shutdown, or until the window is closed."""
        ends = dict.fromkeys([self._namespaces[0], self._namespaces[-1]])
        odometry, commands = (' to '.join(rospy.resolve_name(namespace + topic) for namespace in ends)
                              for topic in ('odom', 'cmd_vel'))
        rospy.loginfo(f'TurtleBot 2 ready: {odometry} at {self._timeline.odom_rate:g} Hz, '
                      f'listening on {commands}')
        while not (self._stopping or rospy.is_shutdown()):
            self._take_turn()

    def _take_turn(self):
        """Serve the requests that wait, and advance if it is time to: whatever else arrives meanwhile."""
        if self._paused:
            self._requests.wait(LONGEST_WAIT)
            self._requests.serve_all()
        elif not self._begun:
            self._begin()
        else:
            lead = self._pacer.lead(self._timeline.now)
            is_early = lead > SHORTEST_SLEEP
            if self._requests.wait(min(lead, LONGEST_WAIT) if is_early else 0.0):
                self._settle_and_serve()
            if not is_early:
                self._advance()

    def _settle_and_serve(self):
        if self._lockstep:
            self._lockstep.notice(self._requests.nodes, self._timeline.now / 1e9, unasked=True)
            self._lockstep.wait()
        self._serve()

    def _serve(self):
        """Serve the requests that wait; in lockstep also what callers ask once they are answered."""
        for _ in range(MOST_ROUNDS if self._lockstep else 1):
            if not self._requests.serve_all(by_name=bool(self._lockstep)):
                break
            if self._lockstep:
                self._lockstep.wait()

    def _begin(self):
        """Publish time zero; in lockstep, once the graph has settled."""
        if self._lockstep and not self._lockstep.has_settled():
            self._requests.wait(LOOK_PERIOD)
            return
        self._begun = True
        self._publish()
        if self._lockstep:
            self._serve()
        self._pacer.restart(self._timeline.now)

    def _advance(self):
        """Simulate to the next tick of the clock, and publish what is due."""
        # Paced by the wall clock, obey commands at the next step.
        is_paced = self._settings.real_time_factor and not self._lockstep
        new_odometry = self._simulation.advance(self._timeline.steps + 1 if is_paced else math.inf)
        unasked = self._requests.nodes
        self._publish(new_odometry)
        if self._lockstep:
            now = self._timeline.now / 1e9
            self._lockstep.notice(unasked, now, unasked=True)
            self._lockstep.notice(self._requests.nodes - unasked, now, unasked=False)
            self._serve()
        if new_odometry and self._settings.gui:
            self._update_window()

    def _publish(self, new_odometry=True):
        """Publish what is due; in lockstep, wait after each until all nodes rest.

        Lockstep publishes the odometry first, so that a loop that the clock wakes has received it.
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
        for name, warning in self._falls.look():
            if warning:
                rospy.logwarn(warning)
            else:
                rospy.loginfo(f'{name} stands upright again')
            self._topics.warn(name, warning)

    def _report_timeouts(self):
        """Say which robots' watchdogs have stopped them, as a Kobuki's driver does."""
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

    def _listen(self):
        inputs = {'cmd_vel': None, 'mobile_base/commands/velocity': None,
                  **{name: name for name in INPUTS}}
        for robot, namespace in enumerate(self._namespaces):
            for topic, mux_input in inputs.items():
                self._subscribe(f'{namespace}{topic}', Twist, self._command, robot, mux_input)
            self._subscribe(f'{namespace}mobile_base/commands/reset_odometry', Empty,
                            self._reset_odometry, robot)
            self._subscribe(f'~{namespace}set_pose', PoseStamped, self._set_pose, robot)
        for name, action in (('~pause_physics', self._pause), ('~unpause_physics', self._unpause),
                             ('~reset_simulation', self._reset)):
            rospy.Service(name, srv.Empty, partial(self._answer, action))

    def _subscribe(self, topic, message_class, action, *arguments):
        """Have the main thread call action(message, *arguments) for each message."""
        # Of what has arrived together rospy reads the latest only, so that a flood costs little.
        rospy.Subscriber(topic, message_class, lambda message: self._requests.put(
            _sender_of(message), partial(action, message, *arguments)), queue_size=1, tcp_nodelay=True)

    def _answer(self, action, request):
        try:
            self._requests.put_and_wait(_sender_of(request), action)
        except TimeoutError as error:
            raise rospy.ServiceException(error) from None
        return srv.EmptyResponse()

    def _command(self, twist, robot, mux_input):
        if self._lockstep and not self._begun:
            # Whether one arrives so early depends on when the connection is made.
            rospy.logwarn_once('lockstep ignores commands before time zero: wait for the first /odom')
            return
        try:
            self._simulation.command(twist.linear.x, twist.angular.z, robot, mux_input)
        except ValueError as error:
            rospy.logwarn_throttle(1.0, f'stopping: {error}')

    def _reset_odometry(self, _message, robot):
        self._simulation.robots[robot].reset_odometry()

    def _set_pose(self, message, robot):
        """Place a robot; while paused, publish its new pose."""
        position, orientation = message.pose.position, message.pose.orientation
        topic, refusal = f'~{self._namespaces[robot]}set_pose', ''
        try:
            self._simulation.robots[robot].set_pose(*checked_pose(
                message.header.frame_id, (position.x, position.y, position.z),
                (orientation.x, orientation.y, orientation.z, orientation.w)))
        except ValueError as error:
            refusal = f'{topic} refused: {error}'
            rospy.logwarn_throttle(1.0, refusal)
        self._topics.warn(topic, refusal)  # RViz and the page do not show the log
        if self._paused and not refusal:
            self._publish_robots()

    def _report_pace(self, reached, share):
        """Warn, in the log and on ~warning, that the simulation is too slow, or has caught up."""
        wanted = self._settings.real_time_factor
        if reached is None:
            text = ''
            rospy.loginfo(f'the simulation keeps pace again: real-time factor {wanted:g}')
        else:
            text = (f'the simulation is too slow: it reaches a real-time factor of {reached:.2g} '
                    f'instead of {wanted:g}')
            help_text = ('fewer robots, no ~gui, a lower ~odom_rate or ~real_time_factor help'
                         if share > BUSY_SHARE else 'perhaps other programs need the processors, '
                         'such as windows that render without a graphics card')
            rospy.logwarn(f'{text}, with {share:.0%} of a processor; {help_text}')
        self._topics.warn('pace', text)

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
        self._requests.put(('', ''), lambda: None)


def _sender_of(message):
    """Return the sender of a message or request: the names of its node and of its topic or service."""
    header = message._connection_header
    return header['callerid'], header.get('topic') or header.get('service', '')
