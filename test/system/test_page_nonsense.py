"""What a page would never say: it moves no robot, and takes the pad from nobody.

Each test speaks the page's own wire format, and sees what came of it from what an honest page can
do next.
"""

import time

import pytest
import rosgraph
import rospy
from geometry_msgs.msg import Twist
from odometry_tests.viewing import View
from odometry_tests.waiting import TIMEOUT, Recorder, wait_until
from std_msgs.msg import String

raw_page = pytest.importorskip('odometry_tests.raw_page', reason='viser is not installed')
from odometry_tests.raw_page import ROBOTS, honest_page, published

SPEED, TURN = 0.2, 0.785  # m/s, rad/s: what the page's sliders say until somebody moves them
LOG_PERIOD = 10.0  # s


@pytest.fixture(scope='module')
def view(master):
    """Start a viewer of two robots."""
    with raw_page.view_of_two('/strange') as running:
        yield running


@pytest.fixture
def commands():
    """Record what each robot is commanded."""
    return {robot: Recorder(f'/strange/{robot}/cmd_vel', Twist) for robot in ROBOTS}


def drive(page, recorder, label='forward'):
    """Hold a button until a command comes, release it, and return the commands until zero."""
    recorder.clear()

    def command():
        page.hold(label)
        return any(message != Twist() for message in recorder.messages)

    wait_until(command, TIMEOUT, 'a command', period=0.05)
    page.set(label, True)
    recorder.wait_for(lambda m: m == Twist(), what='the zero of a release')
    return [message for message in recorder.messages if message != Twist()]


@pytest.mark.parametrize('value', [-5, 1e9, float('nan'), float('inf'), 0, 181, '0.3', True, None,
                                   [0.3], {}], ids=repr)
@pytest.mark.parametrize('slider, button, expected', [
    ('speed (m/s)', 'forward', (SPEED, 0.0)), ('turn (deg/s)', 'left', (0.0, TURN))])
def test_a_speed_beyond_the_slider_is_ignored(view, commands, slider, button, expected, value):
    """The robot is commanded what the slider said before."""
    with honest_page(view) as page:
        page.set(slider, value)
        told = drive(page, commands['robot_1'], button)
    assert {(m.linear.x, round(m.angular.z, 3)) for m in told} == {expected}


@pytest.mark.parametrize('value', ['../evil', '/evil', 'robot_3', '', 'robot_1/', 1, None,
                                   ['robot_1'], 'x' * 1000])
def test_a_robot_that_is_not_listed_is_not_driven(view, commands, value):
    """And the pad goes on driving those that are."""
    with honest_page(view) as page:
        page.set('robot', value)
        assert drive(page, commands['robot_1'])
    assert commanded() <= {f'/strange/{robot}/cmd_vel' for robot in ROBOTS}


def commanded():
    """Return the topics on which somebody may command a robot."""
    topics, _, _ = rosgraph.Master('/test').getSystemState()
    return {topic for topic, _ in topics if topic.endswith('cmd_vel')}


def test_while_no_robot_is_listed_none_is_driven(master):
    """Those that the last page showed have gone, and the next one has not found any yet."""
    recorder = Recorder('/left/robot_1/cmd_vel', Twist)
    with View('__ns:=left') as view:
        with published('/left') as publishers:
            with honest_page(view):
                pass
            wait_until(lambda: not any(p.get_num_connections() for p in publishers), TIMEOUT,
                       'a viewer without a page, that listens to nobody')
        with raw_page.RawPage(view.port) as page:
            page.show()
            for _ in range(10):
                page.hold('forward')
            with published('/left'):
                page.find('robot')
                assert drive(page, recorder)
                assert '/left/cmd_vel' not in commanded()


MALFORMED = {
    'text': 'forward',
    'nothing': b'',
    'noise': b'\xc1\xff\x00',
    'no map': b'\x93\x01\x02\x03',
    'no type': b'\x80',
    'map of numbers': b'\x81\x01\x02',
    'many brackets': b'\x91' * 10000,
    'much': bytes(1 << 20),
}
MESSAGES = {
    'unknown type': {'type': 'Nonsense'},
    'type that is a list': {'type': ['GuiUpdateMessage']},
    'page to the world': {'type': 'ShareUrlRequest'},
    'message of the server': {'type': 'GuiRemoveMessage', 'uuid': 'x'},
    'script for all': {'type': 'RunJavascriptMessage', 'source': 'alert(1)'},
    'update without fields': {'type': 'GuiUpdateMessage'},
    'update with a field too many': {'type': 'GuiUpdateMessage', 'uuid': 'x', 'updates': {},
                                     'excluded_self_client': 1},
    'update of nothing': {'type': 'GuiUpdateMessage', 'uuid': 'x', 'updates': {'value': True}},
    'hold of nothing': {'type': 'GuiButtonHoldMessage', 'uuid': 'x', 'frequency': 10.0},
    'hold without a name': {'type': 'GuiButtonHoldMessage', 'uuid': None, 'frequency': 10.0},
    'camera without a place': {'type': 'ViewerCameraMessage'},
    'camera of NaN': {'type': 'ViewerCameraMessage', **raw_page.CAMERA,
                      'position': [float('nan')] * 3},
    'camera in a line': {'type': 'ViewerCameraMessage', **raw_page.CAMERA, 'wxyz': [1.0]},
}


@pytest.mark.parametrize('data', MALFORMED.values(), ids=MALFORMED)
def test_what_is_no_message_of_a_page_leaves_the_others_theirs(view, commands, data):
    """The server goes on, and so does the pad."""
    with honest_page(view) as page:
        with raw_page.RawPage(view.port) as stranger:
            stranger.show()
            stranger.send_raw(data)
        assert drive(page, commands['robot_1'])
    assert 'Traceback' not in view.process.output


@pytest.mark.parametrize('message', MESSAGES.values(), ids=MESSAGES)
def test_a_message_that_no_page_sends_is_ignored(view, commands, message):
    """Who has sent it may go on, too."""
    with honest_page(view) as page:
        page.send(**message)
        assert drive(page, commands['robot_1'])
    assert 'Traceback' not in view.process.output


@pytest.mark.parametrize('label', ['forward', 'robot'])
@pytest.mark.parametrize('name, value', [('update_cb', []), ('removed', True), ('uuid', 'x'),
                                         ('nonsense', 1)])
def test_only_the_value_of_an_input_can_be_set(view, commands, label, name, value):
    """Its callbacks are not a page's business."""
    with honest_page(view) as page:
        page.set(label, value, name)
        assert drive(page, commands['robot_1'])
        page.set('robot', 'robot_2')
        assert drive(page, commands['robot_2'])
        page.set('robot', 'robot_1')
        assert drive(page, commands['robot_1'])


def test_what_the_simulator_warns_of_is_shown_as_long_as_it_is_there(view):
    """As a text, not as HTML."""
    publisher = rospy.Publisher('/strange/sim_turtlebot/warning', String, queue_size=1, latch=True)
    publisher.publish('too <b>slow')
    with honest_page(view) as page:
        page.wait_for_text('too &lt;b&gt;slow')
        publisher.unregister()
        page.wait_for_text('no simulator here')


def test_a_message_that_is_ignored_leaves_one_line(master):
    """However many there are."""
    with published('/noisy'), View('__ns:=noisy') as view:
        began = time.monotonic()
        with honest_page(view) as page:
            for _ in range(20):
                page.set('speed (m/s)', 1e9)
            view.process.wait_for_output('ignored')
        assert view.process.end() == 0, view.process.output
    lines = view.process.stderr.splitlines()
    assert len(lines) <= 1 + (time.monotonic() - began) / LOG_PERIOD, lines
    assert 'speed (m/s): 1000000000.0' in lines[0]
