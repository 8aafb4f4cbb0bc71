"""Help with what can be typed, and warnings about mistakes: names, and several publishers."""

import pytest
import rospy
from geometry_msgs.msg import Twist
from odometry_common.parameters import Parameters
from odometry_common.publisher_conflicts import ConflictWatch, period_after
from odometry_tests.processes import run_script
from odometry_tests.scripts import ROOT, load_script
from odometry_tests.tutorial import mover, rotator
from odometry_tests.waiting import wait_until

SCRIPTS = sorted(str(path.relative_to(ROOT)) for folder in ('src', 'script')
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


def test_what_the_command_line_set_is_forgotten_at_the_end(ns):
    """So that the next plain run has the defaults. What is set in other ways stays."""
    rospy.set_param(f'{ns}test_movement/speed', 0.2)
    with mover('_distance:=5', '_timeout:=2') as node:
        wait_until(lambda: rospy.get_published_topics(ns), 20.0, 'the node')
        assert node.end() == 0
    assert rospy.get_param(f'{ns}test_movement') == {'speed': 0.2}


def test_a_node_that_another_replaces_leaves_the_parameters_to_it(ns):
    """They have one name, and so the same parameters."""
    with mover('_distance:=5') as old:
        wait_until(lambda: rospy.has_param(f'{ns}test_movement/distance'), 20.0, 'its parameters')
        new = mover('_distance:=5')
        assert old.wait() == 0
        wait_until(lambda: rospy.get_published_topics(ns), 20.0, 'the new node')
        assert rospy.get_param(f'{ns}test_movement/distance') == 5
        with new:
            assert new.end() == 0
    assert not rospy.has_param(f'{ns}test_movement/distance')


@pytest.mark.parametrize('looks, reported', [
    (['a', 'a', 'a'], {}),
    (['a', 'ab', 'ab', 'ab'], {2: 'ab'}),
    (['ab', 'a', 'ac', 'a'], {}),  # b and c were shutting down
    (['a', 'a', 'b', 'b'], {}),  # as after a restart
    (['ab', 'ab', 'abc', 'abc', 'abc'], {1: 'ab', 3: 'abc'}),
    (['ab', 'ab', 'a', 'a', 'ab', 'ab'], {1: 'ab'}),  # one that comes back is no news
    (['ab', 'ab', 'ac', 'ac'], {1: 'ab', 3: 'ac'})])
def test_each_conflict_that_lasts_is_reported_once(looks, reported):
    """A name is a letter here."""
    watch = ConflictWatch()
    said = {number: ''.join(watch.news(set(names))) for number, names in enumerate(looks)}
    assert {number: names for number, names in said.items() if names} == reported


@pytest.mark.parametrize('duration, period', [(0.001, 1.0), (0.01, 5.0), (10.0, 30.0)])
def test_a_slow_master_is_asked_less_often_but_is_asked(duration, period):
    """It may answer slowly once only, on a busy machine."""
    assert period_after(duration) == period
