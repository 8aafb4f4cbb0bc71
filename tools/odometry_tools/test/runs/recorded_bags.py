"""Bags as of a real robot, or of a stranger, and plot_run.py as a user runs it."""

import math

import rosbag
import rospy
from nav_msgs.msg import Odometry
from odometry_tests.messages import odometry
from odometry_tests.processes import run

PERIOD = 0.1  # s
START = 100.0  # s


def metre():
    messages = [odometry(x=0.01 * step, stamp=START + PERIOD * step) for step in range(101)]
    for message in messages:
        message.twist.twist.linear.x = 0.1
    return messages


def record(path, messages, topic='/odom', mode='w'):
    """Write a bag as a real robot's, without commands or the robot's true position, or append."""
    with rosbag.Bag(str(path), mode) as bag:
        for number, message in enumerate(messages):
            bag.write(topic, message, rospy.Time.from_sec(START + PERIOD * number))
    return path


def write_without_speed(path):
    """Write a bag with a finite position, whose speed is not."""
    message = odometry()
    message.twist.twist.linear.x = math.inf
    record(path, [message])


class Foreign(Odometry):
    """Odometry as a bag may define it: with a constant whose name is Python code."""

    _md5sum = 'c' * 32
    _full_text = f'string __import__("pathlib").Path({{!r}}).touch(); y=1\n{Odometry._full_text}'


def write_foreign(path, topic, ran):
    """Write a bag that defines the odometry on a topic itself, with code that would make the file `ran`."""
    Foreign._full_text = Foreign._full_text.format(str(ran))
    record(path, metre())
    return record(path, [Foreign()], topic, 'a')


def plot(*arguments, **options):
    return run('rosrun', 'odometry_tools', 'plot_run.py', *arguments, **options)
