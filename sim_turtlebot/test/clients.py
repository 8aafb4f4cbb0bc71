"""Robot clients as others write them: none of them knows of lockstep.

usage: clients.py KIND

All but the last command the robot, with an angular velocity that shows what they have seen.
"""

import queue
import sys
import threading
from types import SimpleNamespace

import actionlib
import dynamic_reconfigure.client
import dynamic_reconfigure.server
import message_filters
import rospy
import tf
import tf2_ros
from actionlib.msg import TestAction, TestGoal, TestResult
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from std_msgs.msg import Float64
from std_srvs.srv import Trigger, TriggerResponse

LATEST = rospy.Time()
# What dynamic_reconfigure generates from a .cfg file, for one parameter.
SETTINGS = SimpleNamespace(
    all_level=1, defaults={'gain': 1.0}, level={'gain': 1}, min={'gain': 0.0}, max={'gain': 9.0},
    type={'gain': 'double'}, config_description={
        'name': 'Default', 'type': '', 'id': 0, 'parent': 0, 'state': True, 'groups': [],
        'parameters': [{'name': 'gain', 'type': 'double', 'level': 1, 'description': '',
                        'edit_method': '', 'default': 1.0, 'min': 0.0, 'max': 9.0}]})


class Robot:
    """The robot as a client sees and commands it."""

    def __init__(self):
        self.x, self.moved = 0.0, threading.Event()  # m, and whether that is new
        # The same, one by one; None at shutdown, by rospy's signal handler: a Queue could deadlock there.
        self.seen = queue.SimpleQueue()
        rospy.on_shutdown(lambda: self.seen.put(None))
        self._publisher = rospy.Publisher('cmd_vel', Twist, queue_size=10)
        rospy.Subscriber('odom', Odometry, self._on_odometry)

    def _on_odometry(self, message):
        self.x = message.pose.pose.position.x
        self.moved.set()
        self.seen.put(self.x)

    @property
    def is_heard(self):
        return self._publisher.get_num_connections() > 0

    def drive(self, turn=None):
        command = Twist()
        command.linear.x, command.angular.z = 0.2, self.x if turn is None else turn
        self._publisher.publish(command)


def rate(robot, hertz='10'):
    loop = rospy.Rate(float(hertz))
    while not rospy.is_shutdown():
        robot.drive()
        loop.sleep()


def timer(robot):
    rospy.Timer(rospy.Duration(1 / 30), lambda _: robot.drive())
    rospy.spin()


def sleep(robot):
    while not rospy.is_shutdown():
        robot.drive()
        rospy.sleep(0.07)


def wait_for_message(robot):
    while not rospy.is_shutdown():
        robot.drive(rospy.wait_for_message('odom', Odometry).pose.pose.position.x)


def tf_listener(robot):
    transforms, loop = tf.TransformListener(), rospy.Rate(20)
    while not rospy.is_shutdown():
        if transforms.canTransform('odom', 'base_link', LATEST):
            robot.drive(transforms.lookupTransform('odom', 'base_link', LATEST)[0][0])
        loop.sleep()


def tf2_listener(robot):
    transforms = tf2_ros.Buffer()
    tf2_ros.TransformListener(transforms)
    while not rospy.is_shutdown():
        found = transforms.lookup_transform('odom', 'base_footprint', rospy.Time.now(),
                                            rospy.Duration(1.0))
        robot.drive(found.transform.translation.x)
        rospy.sleep(0.02)


def synchronizer(robot):
    topics = [message_filters.Subscriber(name, Odometry)
              for name in ('odom', 'base_pose_ground_truth')]
    synchronized = message_filters.ApproximateTimeSynchronizer(topics, 10, 0.01)
    synchronized.registerCallback(
        lambda odom, truth: robot.drive(odom.pose.pose.position.x + truth.pose.pose.position.x))
    rospy.spin()


def service(robot):
    rospy.Service('~x', Trigger, lambda _: TriggerResponse(True, str(robot.x)))
    ask, loop = rospy.ServiceProxy('~x', Trigger), rospy.Rate(10)
    while not rospy.is_shutdown():
        robot.drive(float(ask().message))
        loop.sleep()


def action(robot):
    """Send goals to the action server, each when there is new odometry.

    One that the clock has this node send may arrive before that clock, and end a tick earlier.
    """
    client = actionlib.SimpleActionClient('wait', TestAction)
    client.wait_for_server()
    while not rospy.is_shutdown():
        robot.moved.clear()
        robot.moved.wait(1.0)
        client.send_goal_and_wait(TestGoal(3))
        robot.drive(robot.x + client.get_result().result)


def latched(robot):
    gain = []
    rospy.Subscriber('gain', Float64, lambda message: gain.append(message.data))
    loop = rospy.Rate(10)
    while not rospy.is_shutdown():
        robot.drive(robot.x * sum(gain[-1:]))
        loop.sleep()


def reconfigure(robot):
    gain = [0.0]

    def on_change(config, _level):
        gain[0] = config['gain']
        return config

    dynamic_reconfigure.server.Server(SETTINGS, on_change)
    loop = rospy.Rate(10)
    while not rospy.is_shutdown():
        robot.drive(robot.x * gain[0])
        loop.sleep()


def action_server(_robot):
    """Take 0.1 s for each unit of a goal."""
    def execute(goal):
        rospy.sleep(0.1 * goal.goal)
        server.set_succeeded(TestResult(goal.goal))

    server = actionlib.SimpleActionServer('wait', TestAction, execute, auto_start=False)
    server.start()
    rospy.spin()


def latching(_robot):
    rospy.Publisher('gain', Float64, latch=True, queue_size=1).publish(0.5)
    rospy.spin()


def tuner(_robot):
    """Change the gain of `reconfigure`, never in the moment in which that looks at it."""
    client = dynamic_reconfigure.client.Client('/client', timeout=30)
    rospy.sleep(0.03)
    loop, gain = rospy.Rate(2), 0
    while not rospy.is_shutdown():
        gain = (gain + 1) % 7
        client.update_configuration({'gain': gain})
        loop.sleep()


def main(functions):
    kind, *parameters = sys.argv[1].split()
    rospy.init_node('client')
    try:
        functions[kind](Robot(), *parameters)
    except rospy.ROSException:  # shutdown
        pass


if __name__ == '__main__':
    main(globals())
