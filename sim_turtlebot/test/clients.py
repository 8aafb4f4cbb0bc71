"""Robot clients as others write them: none of them knows of lockstep.

usage: clients.py KIND

All but the last command the robot, with an angular velocity that shows what they have seen.
"""

import queue
import random
import sys
import threading
import zlib
from types import SimpleNamespace

import actionlib
import rospy
import tf
import tf2_ros
from actionlib.msg import TestAction, TestGoal, TestResult
from geometry_msgs.msg import Point, PointStamped, Twist
from nav_msgs.msg import Odometry
from std_msgs.msg import Header
from std_srvs.srv import Trigger, TriggerResponse

LATEST = rospy.Time()


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


def timer(robot, hertz='30'):
    rospy.Timer(rospy.Duration(1 / float(hertz)), lambda _: robot.drive())
    rospy.spin()


def sleep(robot, hertz='14'):
    while not rospy.is_shutdown():
        robot.drive()
        rospy.sleep(1 / float(hertz))


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


def action_server(_robot):
    """Take 0.1 s for each unit of a goal."""
    def execute(goal):
        rospy.sleep(0.1 * goal.goal)
        server.set_succeeded(TestResult(goal.goal))

    server = actionlib.SimpleActionServer('wait', TestAction, execute, auto_start=False)
    server.start()
    rospy.spin()


def random_node(robot, graph, node, nodes):
    """Say again and again what others have said, and ask one of them; node 0 commands.

    What two nodes do at the same moment they do in either order. So whatever these nodes say depends only
    on what others have said before that moment; then two runs must be the same.
    """
    rng, heard = random.Random(f'{graph} {node}'), {}

    def on_said(message, other):
        heard[other, message.header.stamp] = message.point.x

    for other in range(int(nodes)):
        if rng.random() < 0.5:
            rospy.Subscriber(f'/said_{other}', PointStamped, on_said, other)
    publisher = rospy.Publisher(f'/said_{node}', PointStamped, queue_size=10)
    rospy.Service(f'/ask_{node}', Trigger, lambda _: TriggerResponse(True, str(robot.x)))
    ask = rospy.ServiceProxy(f'/ask_{rng.randrange(int(nodes))}', Trigger)
    asks = rng.random() < 0.5

    def act():
        now = rospy.get_rostime()
        said = sorted((other, when, value) for (other, when), value in [*heard.items()] if when < now)
        answer = ask().message if asks else ''
        value = zlib.crc32(repr((said[-9:], answer, robot.x)).encode()) / 2**32
        publisher.publish(Header(stamp=now), Point(x=value))
        if node == '0':
            robot.drive(value - 0.5)

    ask.wait_for_service()
    robot.seen.get()  # what is said before time begins, another node may miss
    loop, hertz = rng.choice([rate, timer, sleep]), rng.choice([5, 10, 20, 30, 50])
    loop(SimpleNamespace(drive=act), hertz)


def main(functions):
    kind, *parameters = sys.argv[1].split()
    rospy.init_node('client')
    try:
        functions[kind](Robot(), *parameters)
    except rospy.ROSException:  # shutdown
        pass


if __name__ == '__main__':
    main(globals())
