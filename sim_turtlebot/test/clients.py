"""Robot clients as others write them: none of them knows of lockstep.

usage: clients.py KIND

All but the last command the robot, with an angular velocity that shows what they have seen.
"""

import queue
import sys
import threading

import actionlib
import rospy
import tf
import tf2_ros
from actionlib.msg import TestAction, TestGoal, TestResult
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry

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


def main(functions):
    kind, *parameters = sys.argv[1].split()
    rospy.init_node('client')
    try:
        functions[kind](Robot(), *parameters)
    except rospy.ROSException:  # shutdown
        pass


if __name__ == '__main__':
    main(globals())
