"""The tutorials' nodes as processes, and what a test wants to know of the robot."""

import math
from functools import partial

import rosgraph
from nav_msgs.msg import Odometry
from odometry_common.orientation import yaw_from_orientation
from odometry_common.rest import is_slow

from odometry_tests.processes import rosrun
from odometry_tests.waiting import Recorder

NODES = 'sim_turtlebot', 'test_movement', 'rotate_robot'  # with parameters, by their own names


# Each starts a node, and takes its arguments and a Process's options.
simulator = partial(rosrun, 'sim_turtlebot', 'sim_turtlebot_node.py')
# In lockstep, with a clock that is as coarse as the odometry: at any pace no message is lost and no
# command is late, so that the robot does the same on every machine.
simulator_in_step = partial(simulator, '_lockstep:=true', '_clock_rate:=20')
detector = partial(rosrun, 'odom_movement_detector', 'odom_movement_detector.py')
mover = partial(rosrun, 'test_movement', 'test_movement.py')
rotator = partial(rosrun, 'rotate_robot', 'rotate.py')


def forget_parameters():
    """Let the nodes start with their defaults again: what `_name:=value` has set stays set."""
    master = rosgraph.Master('/test')
    for node in {name.split('/')[1] for name in master.getParamNames()} & set(NODES):
        master.deleteParam(f'/{node}')


def speed(message):
    twist = message.twist.twist
    return max(abs(twist.linear.x), abs(twist.angular.z))


def is_at_rest(message):
    return is_slow(message.twist.twist.linear.x, message.twist.twist.angular.z)


def heading(message):
    """Return the yaw (degrees, from -180 to 180) of an Odometry on level ground."""
    return math.degrees(yaw_from_orientation(message.pose.pose.orientation))


class Truth(Recorder):
    """The robot's true motion."""

    def __init__(self, namespace=''):
        super().__init__(f'{namespace}base_pose_ground_truth', Odometry)

    @property
    def stamp(self):
        self.wait_for(what='the robot')
        return self.last.header.stamp.to_sec()

    def wait_until_moving(self):
        self.clear()
        return self.wait_for(lambda m: speed(m) > 0.05, 30.0, 'a moving robot')

    def wait_until_resting(self):
        self.clear()
        return self.wait_for(is_at_rest, 60.0, 'a robot at rest')

    def wait_seconds(self, seconds):
        end = self.stamp + seconds
        return self.wait_for(lambda m: m.header.stamp.to_sec() >= end, 30.0,
                             f'{seconds} s of the robot\'s time')
