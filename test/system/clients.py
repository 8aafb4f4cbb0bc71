"""Clients as others write them, for a robot in lockstep: none of them knows that there is such a thing.

usage: clients.py KIND
"""

import sys
import time

import rospy
import tf
import tf2_ros
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from std_srvs.srv import Trigger, TriggerResponse


def drive(publisher, turn=0.0):
    """Command a velocity that depends on what was seen."""
    command = Twist()
    command.linear.x, command.angular.z = 0.2, turn
    publisher.publish(command)


def rate(publisher, hertz):
    """Command in a loop of a rate, by the latest odometry."""
    seen = []
    rospy.Subscriber('odom', Odometry, lambda message: seen.append(message.pose.pose.position.x))
    loop = rospy.Rate(float(hertz))
    while not rospy.is_shutdown():
        drive(publisher, sum(seen[-1:]))
        loop.sleep()


def timer(publisher):
    """Command in a timer."""
    seen = []
    rospy.Subscriber('odom', Odometry, lambda message: seen.append(message.pose.pose.position.x))
    rospy.Timer(rospy.Duration(1 / 30), lambda _: drive(publisher, sum(seen[-1:])))
    rospy.spin()


def wait_for_message(publisher):
    """Command after each message that is waited for."""
    while not rospy.is_shutdown():
        drive(publisher, rospy.wait_for_message('odom', Odometry).pose.pose.position.x)


def listener(publisher):
    """Command by tf."""
    transforms, loop = tf.TransformListener(), rospy.Rate(20)
    while not rospy.is_shutdown():
        if transforms.canTransform('odom', 'base_link', rospy.Time()):
            drive(publisher, transforms.lookupTransform('odom', 'base_link', rospy.Time())[0][0])
        loop.sleep()


def buffer(publisher):
    """Command by tf2, which waits for a transform."""
    transforms = tf2_ros.Buffer()
    tf2_ros.TransformListener(transforms)
    while not rospy.is_shutdown():
        found = transforms.lookup_transform('odom', 'base_footprint', rospy.Time.now(),
                                            rospy.Duration(1.0))
        drive(publisher, found.transform.translation.x)
        rospy.sleep(0.02)


def service(publisher):
    """Ask a service, this node's own, what to do."""
    seen = [0.0]
    rospy.Subscriber('odom', Odometry, lambda message: seen.append(message.pose.pose.position.x))
    rospy.Service('~turn', Trigger, lambda _: TriggerResponse(True, str(seen[-1])))
    ask, loop = rospy.ServiceProxy('~turn', Trigger), rospy.Rate(10)
    while not rospy.is_shutdown():
        drive(publisher, float(ask().message))
        loop.sleep()


def busy(_publisher):
    """Never rest."""
    while not rospy.is_shutdown():
        pass


def wall(publisher):
    """Sleep by wall time."""
    while not rospy.is_shutdown():
        drive(publisher)
        time.sleep(0.1)


def sleeper(publisher):
    """Sleep on the clock before any command."""
    rospy.sleep(2.0)
    print('awake', flush=True)
    drive(publisher)
    rospy.spin()


if __name__ == '__main__':
    rospy.init_node('client')
    kind, *parameters = sys.argv[1].split()
    kinds = {**globals(), 'tf': listener, 'tf2': buffer}
    try:
        kinds[kind](rospy.Publisher('cmd_vel', Twist, queue_size=10), *parameters)
    except rospy.ROSException:  # shutdown
        pass
