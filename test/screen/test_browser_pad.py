"""The pad of the browser window, in a real browser: it drives, no other page does.

How long a page that says no more goes on driving is tested with a stepped clock, in
unit/test_steering.py.
"""

import contextlib
import http.server
import signal
import threading

import pytest
import rospy
from geometry_msgs.msg import Twist
from odometry_tests.viewing import MOVING

viser = pytest.importorskip('viser', reason='viser is not installed')

# So it is not this that stops the robot, but what the test is about.
WITHOUT_WATCHDOG = pytest.mark.parametrize('view', [{'patient': True}], indirect=True)

# The element is what a Browser waits for when it opens a page.
HOSTILE_PAGE = '''<!DOCTYPE html><title>Win a robot</title><p id="readings"></p><script>
const note = (word) => { document.getElementById('readings').textContent += word + ' '; };
for (const name of ['localhost', '127.0.0.1']) {
  const socket = new WebSocket(`ws://${name}:PORT`, ['viser-vVERSION']);
  let isOpen = false;
  socket.onopen = () => { isOpen = true; note('connected'); };
  socket.onclose = () => { if (!isOpen) note('refused'); };
}
</script>'''


def drive(robot, page):
    """Hold a button until the robot moves, and its commands are heard."""
    page.wait_for_reading('speed', lambda speed: speed == 0)
    robot.commands.clear()
    page.hold('forward')
    robot.wait_until_moving()
    robot.commands.wait_for_publisher()


@contextlib.contextmanager
def hostile_page(view):
    """Serve a page that connects to a viewer's websocket; yield where it is."""
    text = HOSTILE_PAGE.replace('PORT', str(view.port)).replace('VERSION', viser.__version__)

    class Handler(http.server.BaseHTTPRequestHandler):
        def do_GET(self):
            self.send_response(200)
            self.send_header('Content-Type', 'text/html')
            self.end_headers()
            self.wfile.write(text.encode())

        def log_message(self, *_):
            pass

    with http.server.ThreadingHTTPServer(('localhost', 0), Handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f'http://localhost:{server.server_address[1]}'
        server.shutdown()


def test_stop_commands_zero(robot, page):
    """Also if it was not the pad that drove."""
    page.wait_for_reading('speed', lambda speed: speed == 0)
    publisher = rospy.Publisher('cmd_vel', Twist, queue_size=1, latch=True)
    command = Twist()
    command.linear.x = 0.2
    publisher.publish(command)
    robot.wait_until_moving()
    publisher.unregister()
    page.click('stop')
    robot.wait_until_resting()


def test_a_page_that_hangs_in_mid_drive_stops_the_robot(robot, page):
    """It cannot tell whether the button is still held."""
    drive(robot, page)
    with page.hanging():
        robot.wait_until_stopped()


def test_a_page_of_another_origin_gets_no_connection(browser, robot, view, page):
    """While the page itself is open beside it, and stays so."""
    with hostile_page(view) as url, browser.open(url) as hostile:
        hostile.wait_for_text('refused refused')
        assert 'connected' not in hostile.text
        view.process.wait_for_output(f'Origin header is "{url}"')
    shown = page.reading('simulated_time')
    page.wait_for_reading('simulated_time', lambda seconds: seconds > shown)


@WITHOUT_WATCHDOG
def test_the_pad_drives_while_it_is_held(robot, page):
    """Pressed, it drives; released, the last command is zero and no other follows."""
    drive(robot, page)
    page.wait_for_reading('speed', lambda speed: speed == pytest.approx(0.2, abs=0.02))
    page.release()
    robot.wait_until_stopped()


@WITHOUT_WATCHDOG
def test_an_arrow_key_drives_while_it_is_held(robot, page):
    """As the pad does."""
    page.wait_for_reading('speed', lambda speed: speed == 0)
    robot.commands.clear()
    robot.clear()
    page.press_key('ARROW_DOWN')
    robot.wait_for(lambda m: m.twist.twist.linear.x < -MOVING, what='a robot that moves backwards')
    robot.commands.wait_for_publisher()
    page.release_key('ARROW_DOWN')
    robot.wait_until_stopped()


@WITHOUT_WATCHDOG
def test_a_page_that_is_closed_in_mid_drive_stops_the_robot(robot, page):
    """Nobody is left to release the button."""
    drive(robot, page)
    page.close()
    robot.wait_until_stopped()


@WITHOUT_WATCHDOG
def test_the_robot_stops_when_the_viewer_ends(robot, view, page):
    """Its last word is zero, also with somebody's finger on the button; it ends at once."""
    drive(robot, page)
    assert view.process.end(signal.SIGTERM) == 0, view.process.output
    robot.wait_until_stopped()
    page.close()
