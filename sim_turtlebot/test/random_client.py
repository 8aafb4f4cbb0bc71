"""A node that nobody would write: random loops, timers, subscriptions and services.

usage: random_client.py GRAPH NODE NODES

What two nodes do at the same moment they do in either order. So whatever these nodes say depends only
on what others have said before that moment; then two runs must be the same.
"""

import random
import sys
import zlib

import rospy
from geometry_msgs.msg import PointStamped, Twist
from nav_msgs.msg import Odometry
from std_srvs.srv import Trigger, TriggerResponse

RATES = 5.0, 10.0, 20.0, 30.0, 50.0  # Hz


class RandomNode:
    """Says again and again what it has heard, and commands the robot if it is the first node."""

    def __init__(self, graph, node, nodes):
        """Choose what to listen to and what to do."""
        self._rng = random.Random(f'{graph} {node}')
        self._x = 0.0
        self._heard = {}  # values by the topic and the time at which they were said
        rospy.Subscriber('/odom', Odometry, self._on_odometry)
        for other in range(nodes):
            if self._rng.random() < 0.5:
                rospy.Subscriber(f'/said_{other}', PointStamped, self._on_said, other)
        self._said = rospy.Publisher(f'/said_{node}', PointStamped, queue_size=10)
        self._commands = rospy.Publisher('/cmd_vel', Twist, queue_size=10) if node == 0 else None
        rospy.Service(f'/ask_{node}', Trigger, lambda _: TriggerResponse(True, str(self._x)))
        self._ask = rospy.ServiceProxy(f'/ask_{self._rng.randrange(nodes)}', Trigger)
        self._asks = self._rng.random() < 0.5

    def run(self):
        self._ask.wait_for_service()
        rate = self._rng.choice(RATES)
        kind = self._rng.choice(['rate', 'timer', 'sleep'])
        if kind == 'timer':
            rospy.Timer(rospy.Duration(1 / rate), lambda _: self._act(rospy.get_rostime()))
            rospy.spin()
        loop = rospy.Rate(rate)
        while not rospy.is_shutdown():
            if kind == 'sleep':
                rospy.sleep(1 / rate)
            else:
                loop.sleep()
            self._act(rospy.get_rostime())

    def _act(self, now):
        before = sorted((topic, when, value) for (topic, when), value in list(self._heard.items())
                        if when < now)
        answer = self._ask().message if self._asks else ''
        value = zlib.crc32(repr((before[-9:], answer, self._x)).encode()) / 2**32
        message = PointStamped()
        message.header.stamp, message.point.x = now, value
        self._said.publish(message)
        if self._commands:
            command = Twist()
            command.linear.x, command.angular.z = 0.3 * value, value - 0.5
            self._commands.publish(command)

    def _on_odometry(self, message):
        self._x = message.pose.pose.position.x

    def _on_said(self, message, other):
        self._heard[other, message.header.stamp] = message.point.x


if __name__ == '__main__':
    rospy.init_node(f'random_{sys.argv[2]}')
    try:
        RandomNode(*map(int, sys.argv[1:4])).run()
    except rospy.ROSException:  # shutdown
        pass
