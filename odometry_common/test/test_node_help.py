"""Help with what can be typed, and warnings about mistakes: names, and several publishers."""

import pytest
import rospy
from odometry_common.parameters import Parameters
from odometry_tests.processes import run_script
from odometry_tests.scripts import SCRIPTS, load_script
from odometry_tests.tutorial import mover, rotator

TUTORIALS = 'odom_movement_detector', 'test_movement', 'rotate_robot'


@pytest.mark.parametrize('script', SCRIPTS, ids=lambda path: path.name)
def test_help_says_what_a_script_does_and_has(script):
    """Without a master, whatever else is typed; with a remapping that roslaunch adds. A tutorial's node shows it, too."""
    ended = run_script(script, '--help', '__name:=any', '_nonsense:=[',
                       env={'ROS_MASTER_URI': 'http://localhost:1', 'COLUMNS': '200'})
    module = load_script(script)
    assert (ended.wait(), ended.stderr) == (0, ''), ended.output
    assert module.__doc__.splitlines()[0] in ended.stdout
    parameters = getattr(module, 'PARAMETERS', Parameters()).help
    assert parameters in ended.stdout
    assert parameters in module.__doc__ or script.parts[-3] not in TUTORIALS, 'its docstring is its man page'


def warnings(node, text):
    return [line.partition(']: ')[2] for line in node.stderr.splitlines() if text in line]


def test_a_node_warns_once_of_what_it_does_not_know_and_of_others_who_command_its_robot(ns):
    names = f'{ns}rotate_robot', f'{ns}test_movement'
    rospy.set_param(f'{names[0]}/tolerence', 1)
    with mover('_distence:=5', '_speed:=-1e-1') as one, rotator() as two:
        for node in one, two:
            node.wait_for_output(f'{ns}cmd_vel is published by {" and ".join(names)}: stop all but one')
        assert (one.end(), two.end()) == (0, 0)
    assert len(warnings(one, 'is published by')) == len(warnings(two, 'is published by')) == 1
    unknown, = warnings(one, f'unknown: ~distence; it stays until rosparam delete {names[1]}/distence; the ')
    assert unknown.endswith('parameters of this node are ~distance, ~speed, ~relative, ~exit_when_done, ~timeout')
    assert len(warnings(two, 'unknown: ~tolerence; ')) == 1, two.stderr
