"""However a node that moves the robot ends, the robot stops, and nobody sees a traceback."""

import math
import signal

import pytest
import rosnode
from nav_msgs.msg import Odometry
from odometry_tests.processes import hold_port, rosrun
from odometry_tests.waiting import Recorder, wait_until

STOPPING_TIME = 0.3  # s, from the signal to a robot at rest, by the robot's clock
ODOMETRY_PERIOD = 0.05  # s
MOVING = 0.05  # m/s or rad/s
REST = 1e-3


@pytest.fixture(scope='module')
def truth(master):
    """Record the motion of a robot whose own watchdog is off."""
    with rosrun('sim_turtlebot', 'sim_turtlebot_node.py', '_cmd_vel_timeout:=0'):
        recorder = Recorder('base_pose_ground_truth', Odometry)
        recorder.wait_for(timeout=20.0)
        yield recorder


@pytest.fixture(params=['mover', 'rotator'])
def driver(request, truth):
    """Start a node that moves the robot."""
    helpers = []
    if request.param == 'mover':
        helpers.append(rosrun('odom_movement_detector', 'odom_movement_detector.py'))
        node = rosrun('test_movement', 'test_movement.py', '__name:=driver', '_distance:=100')
    else:
        # Out of reach within the test: it turns at full speed limit all the time.
        node = rosrun('rotate_robot', 'rotate.py', '__name:=driver', '_max_angular_speed:=0.2',
                      f'_target:={170 + heading(truth.last):.0f}')
    try:
        wait_until(lambda: speed(truth.last) > MOVING, 20.0,
                   lambda: f'a moving robot; the node printed {node.output}')
        yield node
    finally:
        for process in [node, *helpers]:
            process.__exit__()
        wait_until(lambda: speed(truth.last) < REST, 5.0, 'a robot at rest')


def heading(message):
    """Return the yaw in degrees of a robot that stands level."""
    turn = message.pose.pose.orientation
    return math.degrees(2 * math.atan2(turn.z, turn.w))


def speed(message):
    """Return the greater of the speeds along and about its axes (m/s, rad/s)."""
    twist = message.twist.twist
    return max(abs(twist.linear.x), abs(twist.angular.z))


def ctrl_c(node):
    """Press Ctrl-C in its terminal."""
    node.send(signal.SIGINT)


def terminate(node):
    """Send SIGTERM."""
    node.send(signal.SIGTERM)


def hang_up(node):
    """Close its terminal."""
    node.send(signal.SIGHUP)


def rosnode_kill(_node):
    """Ask the node itself to shut down: what the command of this name does."""
    assert rosnode.kill_nodes(['/driver']) == (['/driver'], [])


ENDINGS = [ctrl_c, terminate, hang_up, rosnode_kill]


@pytest.mark.parametrize('ending', ENDINGS)
def test_the_robot_is_at_rest_at_once(driver, truth, ending):
    """The node's last command is zero; nothing else could stop this robot."""
    ended = truth.last.header.stamp
    ending(driver)
    at_rest = truth.wait_for(lambda m: m.header.stamp > ended and speed(m) < REST,
                             what='a robot at rest')
    took = (at_rest.header.stamp - ended).to_sec()
    assert took <= STOPPING_TIME + ODOMETRY_PERIOD, f'stopped after {took:.2f} s'
    assert driver.wait() == 0, driver.output
    assert 'Traceback' not in driver.output


@pytest.mark.parametrize('ending', ENDINGS)
def test_a_node_that_has_arrived_ends_quietly(truth, ending):
    """After arrival the robot stays at rest."""
    with rosrun('odom_movement_detector', 'odom_movement_detector.py'), \
            rosrun('test_movement', 'test_movement.py', '__name:=driver', '_distance:=0.02') as node:
        node.wait_for_output('stopped')
        ending(node)
        assert node.wait() == 0, node.output
    assert 'Traceback' not in node.output
    truth.wait_for(lambda m: speed(m) < REST, what='a robot at rest')


@pytest.mark.parametrize('signum', [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_a_node_without_a_master_says_so_and_ends_at_once(signum):
    """With parameters to upload too, which rospy answers with a traceback."""
    with hold_port() as port, rosrun(
            'test_movement', 'test_movement.py', '_speed:=0.2',
            env={'ROS_MASTER_URI': f'http://localhost:{port}'}) as node:
        node.wait_for_output('Unable to register with master node')
        assert node.running
        assert node.end(signum, timeout=2.0) == 0
    assert 'Traceback' not in node.output


@pytest.mark.parametrize('package, program', [
    ('odom_movement_detector', 'odom_movement_detector.py'), ('test_movement', 'test_movement.py'),
    ('rotate_robot', 'rotate.py'), ('rotate_robot', 'main.py'),
    ('sim_turtlebot', 'sim_turtlebot_node.py')])
@pytest.mark.parametrize('signum', [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_a_node_that_waits_ends_quietly(master, package, program, signum):
    """Before the first message too: no traceback, exit status 0."""
    name = f'{program[:-3]}_{signum.name}'
    with rosrun(package, program, f'__name:={name}', 'odom:=nowhere') as node:
        wait_until(lambda: f'/{name}' in rosnode.get_node_names(), 20.0, f'a node /{name}',
                   period=0.1)
        assert node.end(signum) == 0, node.output
    assert 'Traceback' not in node.output
