"""A robot that is put somewhere: where it is then, what it believes, and where it cannot be put."""

import math

import pytest
import rospy
from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped, Quaternion
from odometry_tests.pausing import call
from odometry_tests.processes import rosrun
from odometry_tests.robots import place, pose
from odometry_tests.scripts import ROOT
from odometry_tests.simulation import Simulation
from odometry_tests.tutorial import Truth, simulator
from odometry_tests.waiting import TIMEOUT, Recorder, wait_for_subscribers, wait_until
from sim_turtlebot.geometry import about_z
from sim_turtlebot.robot.odometry import STILL
from sim_turtlebot.robot.poses import checked_pose
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

ROOM = str(ROOT / 'sim_turtlebot/worlds/room.urdf')
LEVEL = about_z(0.0)
ON_ITS_SIDE = math.sqrt(0.5), 0.0, 0.0, math.sqrt(0.5)
THERE = 3.0, -1.0, 1.2  # m, m, rad
START = 1.0, 2.0, 0.5


@pytest.mark.parametrize('source', ['world', 'encoder'])
def test_it_stands_where_it_was_put(source):
    """At once and to the bit, whatever it was commanded before, with its wheels as they were.

    If it drives off at once, the way to its new place is no speed.
    """
    simulation = Simulation(odometry_source=source)
    simulation.drive(0.3, 0.5, 2.0)
    robot = simulation.robot
    angles = robot.wheels[0]
    robot.set_pose((3.0, -1.0, 0.0), about_z(1.2))
    there, wheels = robot.ground_truth, robot.wheels
    assert there.position[:2] == (3.0, -1.0)
    assert there.position[2] == pytest.approx(0.0, abs=5e-4)
    assert there.orientation == pytest.approx(about_z(1.2), abs=1e-15)
    assert (there.linear, there.angular, wheels[:2]) == (STILL, STILL, (angles, (0.0, 0.0)))
    assert robot.resting
    simulation.run(2.0)
    assert (robot.ground_truth, robot.wheels) == (there, wheels)
    robot.set_pose((0.0, 0.0, 0.0), LEVEL)
    assert max(math.hypot(*m.linear) for m in simulation.drive(0.3, 0.0, 0.5).odometry) < 0.31


@pytest.mark.parametrize('position, orientation', [
    ((2.0, 0.0, 0.0), LEVEL), ((0.0, 0.0, 0.0), ON_ITS_SIDE), ((-0.7, 0.0, 0.0), LEVEL)],
    ids=['wall', 'floor', 'other robot'])
def test_where_there_is_no_room_it_is_not_put(position, orientation):
    simulation = Simulation((0, 0, 0), (-1.0, 0, 0), world=ROOM)
    simulation.drive(0.3, 0.0, 1.0)
    robot = simulation.robot
    before = robot.body.pose()
    with pytest.raises(ValueError, match=r'^at x .* would be \d+\.\d\d\d m deep in something'):
        robot.set_pose(position, orientation)
    assert robot.body.pose() == before
    simulation.run(1.0)
    assert robot.resting
    assert robot.ground_truth.position == pytest.approx(before[0], abs=1e-3)


@pytest.mark.parametrize('orientation', [(0.0, 0.0, 3e-50, 4e-50), (0.0, 0.0, 3e150, 4e150)])
def test_an_orientation_may_have_any_length(orientation):
    position, unit = checked_pose('world', (1, 2, 3), orientation)
    assert position == (1, 2, 3)
    assert unit == pytest.approx((0.0, 0.0, 0.6, 0.8), abs=1e-15)


@pytest.mark.parametrize('frame, position, orientation, wrong', [
    ('map', STILL, LEVEL, "frame_id is 'map', but must be world, or empty"),
    ('', (math.nan, 0, 0), LEVEL, 'x is nan m, but must be from -10000 to 10000 m'),
    ('world', (0, 0, 10001), LEVEL, 'z is 10001 m, but must be'),
    ('', STILL, (0, 0, 0, 0), r'the orientation is \[0 0 0 0\], but must be'),
    ('', STILL, (0, math.inf, 0, 1), r'the orientation is \[0 inf 0 1\], but must be')])
def test_what_is_no_pose_is_refused_with_what_is_allowed(frame, position, orientation, wrong):
    with pytest.raises(ValueError, match=f'^{wrong}.*$'):
        checked_pose(frame, position, orientation)


def test_rviz_puts_it_where_it_is_said_to_be(simulated_time, ns):
    """By its button 2D Pose Estimate, in the frame world; in another one there is a warning.

    RViz does not show the log; the page shows ~warning, until a place is accepted.
    """
    frames = Recorder('/tf', TFMessage)
    with simulator('_x:=1', '_y:=2', '_yaw:=0.5'), rosrun('sim_turtlebot', 'world_frame.py'):
        warnings = Recorder(f'{ns}sim_turtlebot/warning', String)
        truth = Truth(ns)
        truth.wait_for()
        found = frames.wait_for(lambda m: m.transforms[0].header.frame_id == 'world').transforms[0]
        shift, turn = found.transform.translation, found.transform.rotation
        assert found.child_frame_id == 'odom'
        assert (shift.x, shift.y, 2 * math.atan2(turn.z, turn.w)) == pytest.approx(START, abs=1e-3)
        rviz = rospy.Publisher(f'{ns}initialpose', PoseWithCovarianceStamped, queue_size=10)
        wait_for_subscribers(rviz)
        message = PoseWithCovarianceStamped()
        message.pose.pose = pose(*THERE[:2], yaw=THERE[2]).pose
        message.header.frame_id = 'odom'
        rviz.publish(message)
        warnings.wait_for(lambda m: "frame_id is 'odom', but must be world" in m.data, what='a warning')
        assert {place(m) for m in truth.messages} == {START}
        message.header.frame_id = 'world'
        rviz.publish(message)
        truth.wait_for(lambda m: place(m) == THERE, what=f'a robot at {THERE}')
        wait_until(lambda: 'refused' not in warnings.last.data, TIMEOUT, 'no warning any more')


def test_a_robot_on_its_side_is_warned_of_until_it_stands(simulated_time, ns):
    """In the log and for the page, which of them; at once also while time stands still."""
    # Without a pace nobody is warned that the machine is too slow for it.
    with simulator('_robots:=2', '_odometry_source:=encoder', '_real_time_factor:=0') as node:
        warnings = Recorder(f'{ns}sim_turtlebot/warning', String)
        publisher = rospy.Publisher(f'{ns}sim_turtlebot/robot_2/set_pose', PoseStamped, queue_size=10)
        wait_for_subscribers(publisher)
        for bring_back in (lambda: publisher.publish(pose(2.0, 3.0)), lambda: call('reset_simulation', ns)):
            publisher.publish(pose(-0.001, 3.0, 0.3, orientation=Quaternion(*ON_ITS_SIDE)))
            warning = warnings.wait_for(lambda m: m.data, what='a warning').data
            assert warning == 'robot_2 lies on its side at x 0, y 3; ~reset_simulation brings it back'
            Truth(f'{ns}robot_2/').wait_seconds(1.0)
            call('pause_physics', ns)
            warnings.clear()
            bring_back()
            warnings.wait_for(lambda m: m.data == '', what='no warning')
            warnings.clear()
            call('unpause_physics', ns)
        assert node.end() == 0, node.output
    assert node.output.count('robot_2 lies on its side') == 2
