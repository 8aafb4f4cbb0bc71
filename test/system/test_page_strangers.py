"""Strangers at the page's port: who is not the page is refused, and what it says is checked.

Each speaks the page's own wire format, and what came of it is seen from what an honest page can
do next.
"""

import contextlib
import http.client
import socket
import time

import pytest
import rosgraph
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from odometry_tests.messages import odometry
from odometry_tests.viewing import View
from odometry_tests.waiting import PATIENCE, TIMEOUT, Recorder, wait_until

raw_page = pytest.importorskip('odometry_tests.raw_page', reason='viser is not installed')
from websockets.exceptions import InvalidStatus

SPEED, TURN = 0.2, 0.785  # m/s, rad/s: what the page's sliders say until somebody moves them
LOG_PERIOD = 10.0  # s
ROBOTS = 'robot_1', 'robot_2'


@pytest.fixture(scope='module')
def robots(master):
    """Publish an odometry for each of two robots."""
    publishers = [rospy.Publisher(f'/strange/{robot}/odom', Odometry, queue_size=1, latch=True)
                  for robot in ROBOTS]
    for publisher in publishers:
        publisher.publish(odometry(x=0.0, stamp=5.0))
    yield
    for publisher in publishers:
        publisher.unregister()


@pytest.fixture(scope='module')
def view(robots):
    """Start a viewer of both, with a page that stays open: both are listed all the time."""
    with View('__ns:=strange', '_allowed_hosts:=robots.example, lab:9000') as running, \
            honest_page(running):
        yield running


@pytest.fixture
def commands():
    """Record what each robot is commanded."""
    return {robot: Recorder(f'/strange/{robot}/cmd_vel', Twist) for robot in ROBOTS}


def port(view):
    """Return where the page is."""
    return int(view.url.rpartition(':')[2])


@contextlib.contextmanager
def honest_page(view):
    """Open a page that shows both robots."""
    with raw_page.RawPage(port(view), origin=view.url) as page:
        page.show()
        page.find('robot')
        yield page


def drive(page, recorder, label='forward'):
    """Hold a button until a command comes, release it, and return the commands until zero."""
    def command():
        page.hold(label)
        return any(message != Twist() for message in recorder.messages)

    wait_until(command, TIMEOUT, 'a command', period=0.05)
    page.set(label, True)
    recorder.wait_for(lambda m: m == Twist(), what='the zero of a release')
    return [message for message in recorder.messages if message != Twist()]


@pytest.mark.parametrize('host, origin', [
    (None, 'http://evil.example'),
    (None, 'http://localhost:1'),
    (None, 'null'),
    (None, 'file://'),
    ('evil.example:{port}', 'http://evil.example:{port}'),
    ('evil.example:{port}', None),
    ('evil.example', 'http://localhost:{port}'),
    ('localhost:9000', 'http://localhost:{port}'),
    ('lab:9001', 'http://lab:9001'),
    ('localhost.evil.example:{port}', None),
])
def test_a_stranger_gets_no_websocket(view, host, origin):
    """403, and a line in the log that names it."""
    with pytest.raises(InvalidStatus) as refusal:
        raw_page.RawPage(port(view), host and host.format(port=port(view)),
                         origin and origin.format(port=port(view)))
    assert refusal.value.response.status_code == 403


@pytest.mark.parametrize('host, origin', [
    (None, None),
    (None, 'http://localhost:{port}'),
    ('127.0.0.1:{port}', 'http://127.0.0.1:{port}'),
    ('[::1]:{port}', 'http://[::1]:{port}'),
    ('localhost:9000', 'http://localhost:9000'),
    ('robots.example', 'https://robots.example'),
    ('lab:9000', 'http://lab:9000'),
])
def test_the_page_itself_gets_one_whatever_its_address(view, host, origin):
    """Also through a forwarded port and through a proxy."""
    with raw_page.RawPage(port(view), host and host.format(port=port(view)),
                          origin and origin.format(port=port(view))) as page:
        page.find('forward')


def fetch(view, host):
    """Return status and text of the page, asked for at a host."""
    connection = http.client.HTTPConnection('localhost', port(view), timeout=TIMEOUT * PATIENCE)
    with contextlib.closing(connection):
        connection.request('GET', '/', headers={'Host': host})
        answer = connection.getresponse()
        return answer.status, answer.read()


def test_a_name_that_somebody_bends_to_this_machine_gets_no_page(view):
    """As DNS rebinding does."""
    assert fetch(view, f'evil.example:{port(view)}')[0] == 403
    status, text = fetch(view, f'localhost:{port(view)}')
    assert status == 200 and b'viser' in text.lower()


def test_a_page_of_somebody_else_may_not_frame_it(view):
    """A click that was meant for the other page would drive."""
    connection = http.client.HTTPConnection('localhost', port(view), timeout=TIMEOUT * PATIENCE)
    with contextlib.closing(connection):
        connection.request('GET', '/')
        answer = connection.getresponse()
    assert answer.headers['Content-Security-Policy'] == "frame-ancestors 'self'"


def test_the_log_has_one_line_for_many_strangers(robots):
    """It names the first, in printable characters; no page is needed for it."""
    origin = b'http://evil.example\xff ' + b'x' * 5000
    with View('__ns:=strange') as view:
        began = time.monotonic()
        for _ in range(20):
            with socket.create_connection(('localhost', port(view))) as stranger:
                stranger.sendall(b'GET / HTTP/1.1\r\nHost: localhost:%d\r\nOrigin: %s\r\n\r\n'
                                 % (port(view), origin))
                assert stranger.makefile('rb').readline().split()[1] == b'403'
        view.process.wait_for_output('refused')
        assert view.process.end() == 0, view.process.output
    lines = view.process.stderr.splitlines()
    assert len(lines) <= 1 + (time.monotonic() - began) / LOG_PERIOD, lines
    assert 'http://evil.example\\' in lines[0] and lines[0].isascii()
    assert len(lines[0]) < 400


@pytest.mark.parametrize('value', [-5, 1e9, float('nan'), float('inf'), 0, 0.71, '0.3', True,
                                   None, [0.3], {}])
@pytest.mark.parametrize('label, axis', [('speed (m/s)', 'linear.x'), ('turn (deg/s)', 'angular.z')])
def test_a_speed_beyond_the_slider_is_ignored(view, commands, label, axis, value):
    """The robot is commanded what the slider said before."""
    if label.startswith('turn') and value == 0.71:
        value = 181
    with honest_page(view) as page:
        page.set(label, value)
        button = 'forward' if axis == 'linear.x' else 'left'
        told = drive(page, commands['robot_1'], button)
    assert {(m.linear.x, round(m.angular.z, 3)) for m in told} == \
        {(SPEED, 0.0) if button == 'forward' else (0.0, TURN)}


@pytest.mark.parametrize('value', ['../evil', '/evil', 'robot_3', '', 'robot_1/', 1, None,
                                   ['robot_1'], 'x' * 1000])
def test_a_robot_that_is_not_listed_is_not_driven(view, commands, value):
    """And the pad goes on driving those that are."""
    with honest_page(view) as page:
        page.set('robot', value)
        assert drive(page, commands['robot_1'])
    topics = [topic for topic, _ in rosgraph.Master('/test').getSystemState()[0]]
    allowed = {f'/strange/{robot}/cmd_vel' for robot in ROBOTS}
    assert {topic for topic in topics if topic.endswith('cmd_vel')} <= allowed, topics


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
        with raw_page.RawPage(port(view)) as stranger:
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


def test_a_message_that_is_ignored_leaves_one_line(robots):
    """However many there are."""
    with View('__ns:=strange') as view:
        with honest_page(view) as page:
            for _ in range(20):
                page.set('speed (m/s)', 1e9)
            view.process.wait_for_output('ignored')
        assert view.process.end() == 0, view.process.output
    assert len(view.process.stderr.splitlines()) == 1, view.process.stderr
    assert 'speed (m/s)' in view.process.stderr and '1000000000.0' in view.process.stderr
