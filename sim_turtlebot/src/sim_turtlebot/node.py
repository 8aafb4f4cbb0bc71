"""The ROS node: topics, clock and pacing around the robots and their world.

ROS calls back on threads of its own. They only leave requests; everything that touches the
robots happens on the main thread, between two advances of the simulation.
"""

import math
import queue
import threading
import time

import rospy
from odometry_common.node import leave, run_node
from odometry_common.parameters import ParameterError
from odometry_common.publishing import advertise
from rosgraph_msgs.msg import Clock
from std_msgs.msg import String
from std_srvs.srv import Empty, EmptyResponse
from tf2_msgs.msg import TFMessage

from sim_turtlebot.odometry import EncoderOdometry, WorldOdometry
from sim_turtlebot.pacing import Lockstep, Pacer
from sim_turtlebot.settings import read_settings
from sim_turtlebot.simulation import Simulation, side_by_side
from sim_turtlebot.topics import RobotTopics
from sim_turtlebot.window import NoScreenError
from sim_turtlebot.world_file import WorldFileError

QUEUE_SIZE = 10
SHORTEST_SLEEP = 0.001  # s; a shorter one would oversleep
REPEAT_PERIOD = 0.1  # s of wall time between two odometries while no controller has spoken
LATE_SHARE = 0.25  # of ~lockstep_patience without an answer: none to the repetitions is on its way
SERVICE_TIMEOUT = 5.0  # s


class Simulator:
    """Simulated TurtleBots as a ROS node."""

    def __init__(self, settings):
        """Build the world and advertise; time starts with run()."""
        self._settings = settings
        self._simulation = _new_simulation(settings)
        self._timeline = self._simulation.timeline
        self._pacer = Pacer(settings.real_time_factor, self._tell_of_pace)
        self._lockstep = None
        if settings.lockstep_rate:
            self._lockstep = Lockstep(
                settings.lockstep_rate, self._timeline.step_rate, settings.robots)
        self._paused = False
        self._stopping = False
        self._requests = queue.SimpleQueue()
        rospy.on_shutdown(self._stop)
        self._advertise()
        self._listen()

    def run(self):
        """Simulate until shutdown, or until the window is closed."""
        self._publish_clock()
        self._publish_robots()
        self._pacer.restart(self._timeline.now)
        try:
            while not (self._stopping or rospy.is_shutdown()):
                self._take_turn()
        except rospy.ROSException:
            # At shutdown rospy may close a topic while it is being published.
            if not self._stopping:
                raise

    def _take_turn(self):
        """Serve one request if there is one, else advance if it is time to."""
        if not self._requests.empty() or self._paused:
            self._requests.get()()
        elif self._lockstep and self._lockstep.must_wait(self._timeline.steps):
            self._wait_for_controllers()
        else:
            lead = self._pacer.lead(self._timeline.now)
            if lead > SHORTEST_SLEEP:
                self._serve(lead)
            else:
                self._advance()

    def _serve(self, timeout):
        """Wait for a request for so long (s of wall time) and serve it; False if none came."""
        try:
            self._requests.get(timeout=timeout)()
        except queue.Empty:
            return False
        return True

    def _wait_for_controllers(self):
        if not self._lockstep.started:
            self._wait_for_first_command()
            return
        patience = self._settings.lockstep_patience
        if not self._serve(patience) and self._lockstep.give_up():
            rospy.logwarn(f'lockstep: no command for {patience:g} s of wall time; going on '
                          'without waiting until there is one')

    def _wait_for_first_command(self):
        """Repeat the odometry until there is a command.

        Answers to earlier repetitions may still be on their way then. They must not be taken
        for answers to the next odometry. Nothing in a Twist tells them apart, only that no more
        of them come.
        """
        if not self._serve(REPEAT_PERIOD):
            self._publish_clock()
            self._publish_robots()
        if self._lockstep.started:
            patience = self._settings.lockstep_patience
            end = time.monotonic() + patience
            while not self._stopping and time.monotonic() < end:
                if not self._serve(LATE_SHARE * patience):
                    break

    def _last_step(self):
        """Return the step past which the wall clock or the controllers matter again."""
        if self._settings.real_time_factor:
            return self._timeline.steps + 1
        return self._lockstep.last_step if self._lockstep else math.inf

    def _advance(self):
        """Let time pass, and publish what is due then."""
        new_odometry = self._simulation.advance(self._last_step())
        if self._timeline.clock_is_due:
            self._publish_clock()
        if new_odometry:
            self._publish_robots()
            if self._settings.gui:
                self._update_window()

    def _update_window(self):
        if self._simulation.world.window_closed:
            rospy.loginfo('the window has been closed')
            self._stopping = True
        else:
            self._simulation.world.look_at(self._simulation.robots[0].body)

    def _publish_clock(self):
        if self._clock:
            self._clock.publish(Clock(self._stamp()))

    def _publish_robots(self):
        stamp = self._stamp()
        number = self._timeline.odometry_count
        self._tf.publish(TFMessage([topics.publish(stamp, number) for topics in self._topics]))

    def _stamp(self):
        if self._settings.use_sim_time:
            return rospy.Time(0, self._timeline.now)
        return rospy.Time.now()

    def _advertise(self):
        settings = self._settings
        paced = settings.real_time_factor != 0 and not settings.lockstep_rate
        # A queue keeps a subscriber that has stopped reading from stopping the simulation. It
        # costs much time, so there is none where every microsecond counts.
        queue_size = QUEUE_SIZE if paced else None
        self._clock = None
        if settings.use_sim_time:
            self._clock = advertise('/clock', Clock, queue_size)
        self._tf = advertise('/tf', TFMessage, queue_size)
        self._topics = [RobotTopics(robot, namespace, queue_size) for robot, namespace
                        in zip(self._simulation.robots, _namespaces(settings.robots))]

        self._warning = rospy.Publisher('~warning', String, queue_size=QUEUE_SIZE, latch=True)
        self._warning.publish('')

    def _listen(self):
        for index, topics in enumerate(self._topics):
            topics.subscribe(
                lambda linear, angular, index=index: self._requests.put(
                    lambda: self._command(index, linear, angular)),
                lambda robot=self._simulation.robots[index]: self._requests.put(
                    robot.reset_odometry))
        for name, action in (('~pause_physics', self._pause), ('~unpause_physics', self._unpause),
                             ('~reset_simulation', self._reset)):
            rospy.Service(name, Empty, lambda _, action=action: self._do(action))

    def _do(self, action):
        """Have the main thread do something, and wait until it has."""
        done = threading.Event()

        def serve():
            action()
            done.set()

        self._requests.put(serve)
        done.wait(SERVICE_TIMEOUT)
        return EmptyResponse()

    def _command(self, index, linear, angular):
        if self._lockstep:
            self._lockstep.heard(index)
        try:
            self._simulation.command(linear, angular, index)
        except ValueError as error:
            rospy.logwarn_throttle(1.0, f'stopping: {error}')

    def _tell_of_pace(self, reached):
        """Warn, in the log and for the page, that the machine is too slow, or has caught up."""
        wanted = self._settings.real_time_factor
        if reached is None:
            text = ''
            rospy.loginfo(f'the simulation keeps pace again: real-time factor {wanted:g}')
        else:
            text = (f'this machine is too slow: it reaches a real-time factor of {reached:.2g} '
                    f'instead of {wanted:g}')
            rospy.logwarn(f'{text}; fewer robots, a lower ~odom_rate or ~real_time_factor help')
        self._warning.publish(text)

    def _pause(self):
        self._paused = True

    def _unpause(self):
        self._paused = False
        self._pacer.restart(self._timeline.now)

    def _reset(self):
        """Time and robots back to the start."""
        self._simulation.reset()
        if self._lockstep:
            self._lockstep.restart()
        self._pacer.restart(self._timeline.now)
        self._publish_clock()
        self._publish_robots()

    def _stop(self):
        self._stopping = True
        self._requests.put(lambda: None)


def _new_simulation(settings):
    return Simulation(side_by_side(settings.robots, settings.x, settings.y, settings.yaw),
                      lambda index: _new_odometry(settings, index), settings.odom_rate,
                      settings.cmd_vel_timeout, settings.gui, settings.world)


def _new_odometry(settings, index):
    if settings.odometry_source == 'world':
        return WorldOdometry()
    return EncoderOdometry(settings.gyro, settings.wheel_slip, settings.wheel_noise,
                           settings.gyro_noise, seed=settings.seed + index)


def _namespaces(robots):
    return [''] if robots == 1 else [f'robot_{number}/' for number in range(1, robots + 1)]


def _simulate():
    settings = read_settings()
    try:
        simulator = Simulator(settings)
    except NoScreenError as error:
        raise ParameterError('~gui', True, f'false where {error}') from None
    except WorldFileError as error:
        raise ParameterError('~world', settings.world, error) from None
    simulator.run()
    if settings.gui:
        leave()  # PyBullet would wait for its window's thread, which may not end


def main(documentation):
    """Run the node, of which its script has the documentation."""
    # disable_rostime: the clock is ours, so there is none to subscribe to and wait for.
    run_node('sim_turtlebot', _simulate, documentation, disable_rostime=True)
