"""A simulator that is reset: each episode is the first again, to the byte."""

import itertools
import math

import pytest
import rospy
from geometry_msgs.msg import Twist
from lockstep_runs import bytes_of, step
from nav_msgs.msg import Odometry
from odometry_tests.messages import stamp
from odometry_tests.pausing import call
from odometry_tests.robots import twist
from odometry_tests.scripts import ROOT
from odometry_tests.tutorial import simulator_in_step
from odometry_tests.waiting import Recorder, wait_for_subscribers
from sensor_msgs.msg import Imu, LaserScan
from tf2_msgs.msg import TFMessage

LENGTH = 3  # s of simulated time in an episode
TOPICS = {'/odom': (Odometry, 20), '/scan': (LaserScan, 10), '/tf': (TFMessage, 20),
          '/mobile_base/sensors/imu_data': (Imu, 20)}  # with their rates (Hz)
ALL_NOISE = ['_odometry_source:=encoder', '_wheel_slip:=0.02', '_wheel_noise:=0.02',
             '_gyro_noise:=0.02', '_gyro_drift:=0.01', '_scan:=true', '_scan_noise:=0.01',
             f'_world:={ROOT}/sim_turtlebot/worlds/room.urdf', '_real_time_factor:=0']

pytestmark = pytest.mark.usefixtures('simulated_time')


def as_sent(messages):
    """Return the messages of an episode as bytes, without repetitions."""
    return [one for one, _ in itertools.groupby(map(bytes_of, messages))]


def test_after_a_reset_an_episode_is_the_same_bytes(master):
    """With a command before each step."""
    recorders = {topic: Recorder(topic, kind) for topic, (kind, _) in TOPICS.items()}
    publisher = rospy.Publisher('cmd_vel', Twist, queue_size=10, tcp_nodelay=True)
    episodes = []
    with simulator_in_step('_paused:=true', *ALL_NOISE):
        wait_for_subscribers(publisher)
        for recorder in recorders.values():
            recorder.wait_for_publisher()
        for _ in range(3):
            for number in range(20 * LENGTH + 1):
                publisher.publish(twist(0.4 * math.cos(number / 9), 2.0 * math.sin(number / 5)))
                step(1)
            for recorder in recorders.values():
                recorder.wait_for(lambda m: stamp(m) == LENGTH, what='the end of the episode')
            episodes.append({topic: as_sent(recorder.messages) for topic, recorder in recorders.items()})
            for recorder in recorders.values():
                recorder.clear()
            call('reset_simulation')
    for topic, (_, rate) in TOPICS.items():
        first, *others = (episode[topic] for episode in episodes)
        assert len(first) == rate * LENGTH + 1, topic
        assert others == [first, first], topic
