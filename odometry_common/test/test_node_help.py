"""Help with what can be typed, and warnings about mistakes."""

import pytest
import rospy
from geometry_msgs.msg import Twist
from odometry_common.parameters import Parameters
from odometry_tests.forked import run_script
from odometry_tests.scripts import ROOT, load_script
from odometry_tests.tutorial import mover, rotator

SCRIPTS = sorted(str(path.relative_to(ROOT)) for folder in ('src', 'script', 'scripts')
                 for path in ROOT.glob(f'*/{folder}/*.py') if path.parent.parent.name != 'test')


@pytest.mark.parametrize('script', SCRIPTS)
def test_help_says_what_a_script_does_and_has(script):
    """Without a master, whatever else is typed; with a remapping that roslaunch adds."""
    ended = run_script(script, '--help', '__name:=any', '_nonsense:=[',
                       env={'ROS_MASTER_URI': 'http://localhost:1', 'COLUMNS': '200'})
    module = load_script(script)
    assert (ended.wait(), ended.stderr) == (0, ''), ended.output
    assert module.__doc__.splitlines()[0] in ended.stdout
    assert getattr(module, 'PARAMETERS', Parameters()).help in ended.stdout


def warnings(node, text):
    return [line.partition(']: ')[2] for line in node.stderr.splitlines() if text in line]


def test_a_node_warns_once_of_what_it_does_not_know_and_of_others_who_command_its_robot(ns):
    """Two nodes at once, and a third later."""
    one_name, two_name, third_name = f'{ns}rotate_robot', f'{ns}test_movement', rospy.get_name()
    rospy.set_param(f'{one_name}/tolerence', 1)
    with mover('_distence:=5', '_speed:=-1e-1', '--foo') as one, rotator() as two:
        conflict = f'{ns}cmd_vel is published by {one_name} and {two_name}'
        for node in one, two:
            node.wait_for_output(f'{conflict}: stop all but one')
        third = rospy.Publisher(f'{ns}cmd_vel', Twist, queue_size=1)
        for node in one, two:
            node.wait_for_output(f'{conflict} and {third_name}: stop all but one')
        assert (one.end(), two.end()) == (0, 0)
    third.unregister()
    assert len(warnings(one, 'is published by')) == len(warnings(two, 'is published by')) == 2
    assert warnings(one, 'ignored') == ["ignored: '--foo'; see --help"]
    unknown, = warnings(one, 'unknown: ~distence; the parameters of this node are ')
    assert unknown.endswith('~distance, ~speed, ~relative, ~exit_when_done, ~timeout')
    assert len(warnings(two, 'unknown: ~tolerence; ')) == 1, two.stderr
    assert not rospy.has_param(f'{two_name}/distence'), 'the next run would warn of it'
