"""What is typed by mistake, and help with it: no node takes it without a word."""

import pytest
import rospy
from geometry_msgs.msg import Twist
from odometry_common.usage import parameters
from odometry_tests.forked import run_script
from odometry_tests.scripts import ROOT, load_script
from odometry_tests.tutorial import mover, rotator

SCRIPTS = sorted(str(path.relative_to(ROOT)) for folder in ('src', 'script', 'scripts')
                 for path in ROOT.glob(f'*/{folder}/*.py') if path.parent.parent.name != 'test')
THERE = '/rivals'


@pytest.mark.parametrize('script', SCRIPTS)
def test_help_says_what_a_script_does_and_has(script):
    """Without a master, whatever else is typed; with a remapping that roslaunch adds."""
    ended = run_script(script, '--help', '__name:=any', '_nonsense:=[',
                       env={'ROS_MASTER_URI': 'http://localhost:1', 'COLUMNS': '200'})
    documentation = load_script(script).__doc__
    assert (ended.status, ended.stderr) == (0, ''), ended
    assert documentation.splitlines()[0] in ended.stdout
    assert all(name in ended.stdout for name in parameters(documentation))


def warnings(node, text):
    """Return what a node has warned of with this text."""
    return [line.partition(']: ')[2] for line in node.stderr.splitlines() if text in line]


def test_a_node_warns_once_of_what_it_does_not_know_and_of_each_who_commands_its_robot(master):
    """Two nodes at once, and a third later."""
    rospy.set_param(f'{THERE}/rotate_robot/tolerence', 1)
    there = {'ROS_NAMESPACE': THERE}
    with mover('_distence:=5', '_speed:=-1e-1', '--foo', env=there) as one, rotator(env=there) as two:
        one.wait_for_output(f'{THERE}/cmd_vel is also published by {THERE}/rotate_robot: ')
        two.wait_for_output(f'{THERE}/cmd_vel is also published by {THERE}/test_movement: ')
        third = rospy.Publisher(f'{THERE}/cmd_vel', Twist, queue_size=1)
        one.wait_for_output(f'{THERE}/rotate_robot, {rospy.get_name()}: ')
        two.wait_for_output(f'{THERE}/test_movement, {rospy.get_name()}: ')
        assert (one.end(), two.end()) == (0, 0)
    third.unregister()
    assert len(warnings(one, 'is also published by')) == 2, one.stderr
    assert len(warnings(two, 'is also published by')) == 2, two.stderr
    assert warnings(one, 'ignored') == ["ignored: '--foo'; --help tells what this node understands"]
    unknown, = warnings(one, 'unknown: ~distence; the parameters of this node are ')
    assert unknown.endswith('~distance, ~speed, ~relative, ~exit_when_done, ~timeout')
    assert len(warnings(two, 'unknown: ~tolerence; ')) == 1, two.stderr
    assert not rospy.has_param(f'{THERE}/test_movement/distence'), 'the next run would warn of it'
