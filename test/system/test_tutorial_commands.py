"""The commands of the tutorials, exactly as a reader types them, in real time."""

import contextlib

import pytest
import yaml
from nav_msgs.msg import Odometry
from odometry_tests.processes import Process
from odometry_tests.tutorial import Distance
from odometry_tests.waiting import Recorder, wait_until


def command(line):
    """Start what a reader types into a terminal."""
    return Process(*line.split())


@pytest.fixture(scope='module')
def robot(master):
    """Start a simulated robot as the README says."""
    with command('rosrun sim_turtlebot sim_turtlebot_node.py') as process:
        Recorder('odom', Odometry).wait_for(timeout=20.0)
        yield process


def test_odometry_has_the_fields_of_the_tutorial(robot):
    """What `rostopic echo /odom -n1` prints is the message the tutorial shows."""
    echo = command('rostopic echo /odom -n1')
    assert echo.wait() == 0, echo.output
    message = yaml.safe_load(echo.stdout.replace('---', ''))
    assert list(message) == ['header', 'child_frame_id', 'pose', 'twist']
    assert message['header']['frame_id'] == 'odom'
    assert message['child_frame_id'] == 'base_footprint'
    assert list(message['pose']['pose']) == ['position', 'orientation']
    variances = [float(number) for number in message['pose']['covariance'][::7]]
    assert variances == [1e-05, 1e-05, 1e12, 1e12, 1e12, 0.001]
    assert list(message['twist']['twist']) == ['linear', 'angular']
    assert not any(message['twist']['covariance'])


def test_the_heading_printer_prints_yaws_and_quaternions(robot):
    """The second tutorial begins with main.py."""
    with command('rosrun rotate_robot main.py') as printer:
        printer.wait_for_output('[')
        wait_until(lambda: len(printer.stdout.splitlines()) > 20, 20.0, '20 lines')
        assert printer.end() == 0, printer.output
    lines = printer.stdout.splitlines()
    yaws = [float(line) for line in lines if not line.startswith('[')]
    quaternions = [line.strip('[]').split() for line in lines if line.startswith('[')]
    assert yaws and all(abs(yaw) < 1e-3 for yaw in yaws)
    assert [len(numbers) for numbers in quaternions] == [4] * len(quaternions)


def test_the_robot_drives_two_metres_and_rostopic_shows_it(robot):
    """The first tutorial: detector, mover and a look at the moved distance, 20 s long."""
    with contextlib.ExitStack() as terminals:
        terminals.enter_context(command('rosrun odom_movement_detector odom_movement_detector.py'))
        # Bare rospy may never hear of a publisher that starts at the same moment.
        Distance().wait_for()
        echo = terminals.enter_context(command('rostopic echo /moved_distance'))
        terminals.enter_context(command('rosrun test_movement test_movement.py'))

        def distances():
            return [float(line.split()[1]) for line in echo.stdout.splitlines()
                    if line.startswith('data:')]
        def stands_at_the_goal():
            # How far beyond it the robot rolls is seen in lockstep: here the machine reacts too.
            last = distances()[-20:]
            return last[-1:] >= [2.0] and len(last) == 20 and len(set(last)) == 1

        wait_until(stands_at_the_goal, 60.0,
                   lambda: f'a second at the goal; it printed {distances()[-20:]}')
        seen = distances()
    assert seen == sorted(seen), 'the distance went back'


def test_the_robot_turns_to_ninety_degrees(robot):
    """The second tutorial ends with rotate.py."""
    with command('rosrun rotate_robot rotate.py') as controller:
        def heading():
            lines = controller.stdout.splitlines()
            return float(lines[-1].split(':')[1]) if lines else 0.0
        wait_until(lambda: abs(heading() - 1.5708) < 0.00174, 30.0,
                   lambda: f'90 degrees; it printed {controller.stdout[-200:]}')
    assert controller.stdout.startswith('target=90.0 current:')
