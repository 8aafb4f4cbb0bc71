"""The node of docs/scan.md stops its robot, before a wall and when it ends."""

import sys

from geometry_msgs.msg import Twist
from odometry_tests.pausing import moves_on
from odometry_tests.processes import Process
from odometry_tests.scripts import ROOT
from odometry_tests.tutorial import Truth, simulator_in_step
from odometry_tests.waiting import Recorder, wait_until
from sim_turtlebot.kobuki import DEPTH_CAMERA

NODE = sys.executable, ROOT / 'docs/example/src/stop_before_wall.py'
DISTANCE = 1.0  # m
CORRIDOR = f'_world:={ROOT}/sim_turtlebot/worlds/corridor.urdf'
END = 5.0  # m, where the corridor ends
CLEAR = 0.5  # m, between the camera and the end of the corridor
BRAKES = 0.03  # m, driven between two scans and while braking
CREEP = 1e-9  # m, of a robot at rest; the last digits of its brakes
STOPPING_TIME = 0.15  # s, to brake, from the pause in which the node ended


def test_its_robot_stops_when_the_node_ends_and_before_the_wall(simulated_time):
    """Half a metre before the end of the corridor, as docs/scan.md has it."""
    truth, commands = Truth(), Recorder('cmd_vel', Twist)
    with simulator_in_step('_cmd_vel_timeout:=0', '_scan:=true', CORRIDOR, '_real_time_factor:=5'):
        # Plain rospy may never learn of a publisher that starts at the same moment.
        truth.wait_for(what='a robot')
        with Process(*NODE) as node:
            truth.wait_until_moving()
            commands.wait_for()

            def end():
                assert node.end() == 0, node.output
                wait_until(lambda: commands.last == Twist(), 10.0, 'zero as the last command')

            assert moves_on(truth, end) <= STOPPING_TIME
            assert truth.last.pose.pose.position.x < DISTANCE, 'it had stopped before'
        with Process(*NODE) as node:
            truth.wait_until_moving()
            there = truth.wait_until_resting().pose.pose.position
            truth.wait_seconds(5.0)
            assert abs(truth.last.pose.pose.position.x - there.x) < CREEP, node.output
    clear = END - there.x - DEPTH_CAMERA[0]
    assert CLEAR - BRAKES < clear < CLEAR, f'{clear:.3f} m'
    assert abs(there.y) < 0.05
