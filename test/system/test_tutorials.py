"""The tutorials as launch files start them, as fast as the machine can, without a control delay."""

import pytest
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from odometry_tests.processes import Process
from odometry_tests.scripts import ROOT
from odometry_tests.tutorial import Distance, Truth, heading, speed
from odometry_tests.waiting import Recorder

WALL, RADIUS = 2.0, 0.18  # m: the face of the wall in the example world, and of the robot

pytestmark = pytest.mark.usefixtures('simulated_time')


def launch(file, *arguments):
    return Process('roslaunch', 'odometry_launch', file, 'lockstep:=true', 'real_time_factor:=0', *arguments)


def test_two_robots_drive_two_metres_and_stay_there():
    """Straight ahead, as each detector counts it; at rest for five seconds of their time."""
    with launch('move_two_meters.launch', 'robots:=2'):
        for namespace, left in ('/robot_1/', 0.0), ('/robot_2/', 1.0):
            truth, commands = Truth(namespace), Recorder(f'{namespace}cmd_vel', Twist)
            moved = Distance(namespace).wait_until_arrived(2.0)
            assert 2.0 <= moved <= 2.01
            truth.clear()
            place = truth.wait_for(lambda m: speed(m) == 0, what='rest')
            position = place.pose.pose.position
            assert position.x == pytest.approx(moved, abs=0.001)
            assert position.y == pytest.approx(left, abs=0.002)
            assert heading(place) == pytest.approx(0.0, abs=0.1)
            for recorder in truth, commands:
                recorder.clear()
            assert all(m.pose == place.pose for m in truth.wait_for_count(100))
            assert all(m == Twist() for m in commands.wait_for_count(100))


def test_a_robot_turns_to_a_heading_and_stays_there():
    """For a second of its time."""
    with launch('rotate.launch', 'target:=-90'):
        odometry = Recorder('odom', Odometry)
        odometry.wait_for(lambda m: abs(heading(m) + 90) < 0.1, what='the heading')
        odometry.clear()
        headings = [heading(message) for message in odometry.wait_for_count(20)]
    assert headings == pytest.approx([-90.0] * 20, abs=0.1)


def test_wheels_slip_before_a_wall_and_their_encoders_count_on():
    """The whole distance; the robot itself stands where it touches the wall, a metre from its start."""
    odometry, truth = Recorder('odom', Odometry), Truth()
    with launch('move_two_meters.launch', f'world:={ROOT}/sim_turtlebot/worlds/room.urdf',
                'odometry_source:=encoder', 'x:=1', 'distance:=1.5', 'speed:=0.2'):
        assert Distance().wait_until_arrived(1.5) < 1.52
        truth.clear()
        place = truth.wait_for(lambda m: speed(m) < 0.01, what='rest').pose.pose.position
        assert place.x == pytest.approx(WALL - RADIUS, abs=0.05)
        assert odometry.last.pose.pose.position.x > place.x - 1.0 + 0.5
