"""What the demo shows during a run and how it judges it, from messages and a clock of ours."""

import io
import math
import re
from types import SimpleNamespace

import pytest
from odometry_launch import following
from odometry_launch.monitors import MoveMonitor, RotateMonitor
from odometry_launch.options import launch_arguments, parse
from odometry_launch.silence import Silence
from odometry_tests.messages import odometry
from std_msgs.msg import Float64

REWRITE = '\r\x1b[K'


class ScriptedMonitor:
    """A robot that moves on for half a second while the demo sleeps, and has arrived after ten."""

    def __init__(self):
        """Begin at zero."""
        self.now, self.end = 0.0, None

    def progress(self):
        """Return one line."""
        return f'{self.now:.1f} s'

    def sleep(self, duration):
        """Let the robot go on until the next look, a tenth of a second later."""
        assert duration == 0.1
        self.now += 0.5
        if self.now >= 5.0:
            self.end = self.now


@pytest.fixture
def watch(monkeypatch):
    """Return a function that follows the scripted run and returns the output."""
    def watched(live):
        monitor, output = ScriptedMonitor(), io.StringIO()
        output.isatty = lambda: live
        monkeypatch.setattr(following, 'time', monitor)
        monkeypatch.setattr('sys.stdout', output)
        following._watch(monitor, SimpleNamespace(check=lambda: None),
                    SimpleNamespace(look=lambda _: None))
        monkeypatch.undo()
        return output.getvalue()

    return watched


def test_on_a_terminal_one_line_is_rewritten_at_each_look(watch):
    """Ten times a second, and the last one stays."""
    assert watch(live=True) == ''.join(
        f'{REWRITE}{0.5 * look:.1f} s' for look in range(11)) + '\n'


def test_elsewhere_there_is_a_line_every_two_simulated_seconds(watch):
    """Without control characters, and the end."""
    assert watch(live=False) == '0.0 s\n2.0 s\n4.0 s\n5.0 s\n'


@pytest.mark.parametrize('factor, patience', [(1.0, 10.0), (0.0, 10.0), (0.001, 200.0)])
def test_a_robot_of_which_nothing_is_heard_is_worth_one_line(monkeypatch, capsys, factor, patience):
    """At the slowest pace too, and once again after it has gone on."""
    clock = SimpleNamespace(monotonic=lambda: wall)
    monkeypatch.setattr('odometry_launch.silence.time', clock)
    silence = Silence(factor)
    for wall, now, lines in [(0.0, 1.0, 0), (patience - 1.0, 1.0, 0), (patience + 1.0, 1.0, 1),
                             (patience + 2.0, 1.0, 0), (patience + 3.0, 1.1, 0),
                             (patience * 3, 1.1, 1)]:
        silence.look(now)
        assert capsys.readouterr().err.count('demo: nothing has come') == lines, wall


@pytest.fixture
def play(monkeypatch):
    """Return a function that plays messages of topics to a monitor, one of each after the other.

    The last of the topics may be `late` by some messages, or early.
    """
    def played(kind, arguments, topics, late=0):
        callbacks = {}
        monkeypatch.setattr('odometry_launch.monitors.rospy.Subscriber',
                            lambda topic, kind, callback, **_: callbacks.update({topic: callback}))
        monitor = kind(parse(arguments))
        last = [*topics][-1]
        messages = [(number + late * (topic == last), topic, message)
                    for topic, messages in topics.items()
                    for number, message in enumerate(messages)]
        for _, topic, message in sorted(messages, key=lambda message: message[0]):
            callbacks[topic](message)
        return monitor

    return played


@pytest.fixture
def run(play):
    """Return a function that plays a robot's distances to a monitor and returns it."""
    def played(arguments, moved, true=None, **options):
        truth = [odometry(x=x, stamp=0.05 * step) for step, x in enumerate(true or moved)]
        for message, distance, before in zip(truth, moved, [0.0, *moved]):
            message.twist.twist.linear.x = (distance - before) / 0.05
        return play(MoveMonitor, arguments, {'moved_distance': map(Float64, moved),
                                             'base_pose_ground_truth': truth}, **options)

    return played


def shown(monitor):
    """Return all that is printed in the end."""
    return monitor.progress(), monitor.result(), monitor.duration


DRIVE = [0.005 * step for step in range(400)]
AT_ONCE, LATER = [2.0, 2.002, 2.002], [2.0, 2.03, 2.06, 2.06]


@pytest.mark.parametrize('factor', ['0', '1', '20'])
def test_a_robot_that_stops_after_braking_has_done_well(run, factor):
    """At any pace."""
    monitor = run(['--real-time-factor', factor], [*DRIVE, *AT_ONCE])
    assert monitor.end is not None
    summary, complaint = monitor.result()
    assert re.search(r'moved distance +2\.002 m', summary) and complaint is None


def test_in_lockstep_a_robot_that_goes_on_is_complained_of(run):
    """Its controller has answered each odometry, so that only braking is left."""
    monitor = run(['--real-time-factor', '20'], [*DRIVE, *LATER])
    assert monitor.result()[1] == 'not between 2.000 and 2.007 m'


def test_in_real_time_the_pace_of_the_machine_is_not_judged(run):
    """A command that comes late because the processors were busy is no fault of the robot."""
    assert run([], [*DRIVE, *LATER]).result()[1] is None


@pytest.mark.parametrize('factor', ['1', '20'])
@pytest.mark.parametrize('error', [-0.01, 0.01])
def test_a_robot_that_is_not_where_its_odometry_says_is_complained_of(run, factor, error):
    """A centimetre in two metres."""
    moved = [*DRIVE, *AT_ONCE]
    monitor = run(['--real-time-factor', factor], moved, [distance + error for distance in moved])
    assert monitor.result()[1] == 'the two distances do not agree'


@pytest.mark.parametrize('moved', [DRIVE, [*DRIVE, 2.0], [*DRIVE[:300], *[DRIVE[300]] * 50]])
def test_who_still_drives_or_stands_too_early_has_not_arrived(run, moved):
    """The demo waits for more."""
    assert run([], moved).end is None


def test_distances_that_are_late_are_waited_for(run):
    """The robot stands already, and the sum still grows: its last value is what is shown."""
    truth = [*DRIVE, 2.002, 2.002, 2.002]
    monitor = run([], [*DRIVE, 2.0, 2.001, 2.002], truth)
    assert monitor.end is None


ORDERS = [-30, -1, 0, 1, 30]


@pytest.mark.parametrize('late', ORDERS)
def test_a_drive_is_shown_as_it_was_on_arrival(run, late):
    """Whichever topic comes first, and however the robot is pushed afterwards."""
    pushed = [2.002 + 0.01 * step for step in range(40)]
    monitor = run([], [*DRIVE, *AT_ONCE, *[2.002] * 40, *pushed], late=late)
    assert shown(monitor) == shown(run([], [*DRIVE, *AT_ONCE]))
    assert monitor.progress().endswith(' 2.00 of 2.00 m, 0.00 m/s, 20.1 s')
    assert f'{monitor.duration:.1f}' == '20.1'


@pytest.mark.parametrize('late', ORDERS)
def test_a_turn_is_shown_as_it_was_on_arrival(play, late):
    """The robot creeps on towards its target: each odometry has its own truth beside it."""
    yaws = [math.pi / 2 * (1 - math.exp(-0.5 * 0.05 * step)) for step in range(400)]
    topics = {topic: [odometry(yaw=yaw, stamp=0.05 * step) for step, yaw in enumerate(yaws)]
              for topic in ('odom', 'base_pose_ground_truth')}
    monitor = play(RotateMonitor, ['rotate'], topics, late)
    assert shown(monitor) == shown(play(RotateMonitor, ['rotate'], topics))
    assert re.search(r'heading +89\.90 .*\ntrue turn +89\.90 ', monitor.result()[0])
    assert monitor.progress().endswith(' 89.9 degrees, 0.1 to go, 13.7 s')
    assert f'{monitor.duration:.1f}' == '13.7'


@pytest.mark.parametrize('factor, lockstep', [('1', 'false'), ('0', 'true'), ('0.5', 'true'),
                                              ('3', 'true'), ('100', 'true')])
def test_what_is_not_shown_in_real_time_runs_in_lockstep(factor, lockstep):
    """Both tutorials, so that a run gives the same however fast it is."""
    for tutorial in ('move', 'rotate'):
        options = parse([tutorial, '--real-time-factor', factor])
        assert launch_arguments(options)[1]['lockstep'] == lockstep
