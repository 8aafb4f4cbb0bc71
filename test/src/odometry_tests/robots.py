"""The topics and services of a simulated robot."""

import math

import rospy
from geometry_msgs.msg import Point, Pose, PoseStamped, Quaternion, Twist, Vector3
from nav_msgs.msg import Odometry
from sensor_msgs.msg import JointState
from sim_turtlebot.geometry import about_z

from odometry_tests.pausing import call, pause
from odometry_tests.tutorial import Truth, heading
from odometry_tests.waiting import Recorder, wait_for_subscribers

VELOCITY, BASE = 'cmd_vel', 'mobile_base/commands/velocity'
TELEOP, NAVI = 'cmd_vel_mux/input/teleop', 'cmd_vel_mux/input/navi'


class Robot:
    """The topics and services of a simulated robot."""

    def __init__(self, namespace=''):
        self._namespace = f'/{namespace}'
        self.odometry = Recorder(f'{self._namespace}odom', Odometry)
        self.truth = Truth(self._namespace)
        self.joints = Recorder(f'{self._namespace}joint_states', JointState)
        self._publishers = {topic: rospy.Publisher(self._namespace + topic, Twist, queue_size=10)
                            for topic in (VELOCITY, BASE, TELEOP, NAVI)}

    def wait_until_ready(self):
        for publisher in self._publishers.values():
            wait_for_subscribers(publisher, timeout=20.0)
        for recorder in self.odometry, self.truth, self.joints:
            recorder.wait_for()

    def drive(self, forwards, left=0.0, topic=VELOCITY):
        self._publishers[topic].publish(twist(forwards, left))

    def restart(self):
        """Reset robot and time; return the first odometry and the first truth of the new run.

        Paused, so that no later message pushes them out of a queue before they are read.
        """
        pause(self.odometry, self.truth, namespace=self._namespace)
        for recorder in self.odometry, self.truth:
            recorder.clear()
        call('reset_simulation', self._namespace)
        first = [recorder.wait_for() for recorder in (self.odometry, self.truth)]
        call('unpause_physics', self._namespace)
        return first


def twist(forwards, left=0.0):
    return Twist(Vector3(x=forwards), Vector3(z=left))


def place(message):
    """Return x, y (m) and yaw (rad) of an Odometry, rounded to a hundredth."""
    position = message.pose.pose.position
    return tuple(round(number, 2) + 0.0 for number in
                 (position.x, position.y, math.radians(heading(message))))


def pose(x, y, z=0.0, yaw=0.0, orientation=None, frame='world'):
    """Return a PoseStamped; m, rad, or an orientation instead of the yaw."""
    message = PoseStamped(pose=Pose(Point(x, y, z), orientation or Quaternion(*about_z(yaw))))
    message.header.frame_id = frame
    return message
