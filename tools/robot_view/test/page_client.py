"""A client of the page's websocket that sends whatever a test tells it, as no browser would."""

import contextlib
import threading

import msgspec
import rospy
import viser
import zstandard
from nav_msgs.msg import Odometry
from odometry_tests.messages import odometry
from odometry_tests.waiting import TIMEOUT, wait_until
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect

HEADER = 16  # bytes before the compressed part of a message; its length is in the second eight
ROBOTS = 'robot_1', 'robot_2'
CAMERA = {'wxyz': [1.0, 0.0, 0.0, 0.0], 'position': [0.0, 0.0, 1.0], 'fov': 1.0, 'near': 0.1,
          'far': 100.0, 'image_height': 480, 'image_width': 640, 'look_at': [0.0, 0.0, 0.0],
          'up_direction': [0.0, 0.0, 1.0]}


class PageClient:
    """A websocket to the page, in viser's wire format."""

    def __init__(self, port, origin=None):
        self._shown = {}  # properties by id
        self._websocket = connect(
            f'ws://localhost:{port}', origin=origin, compression=None, max_size=None,
            subprotocols=[f'viser-v{viser.__version__}'])
        threading.Thread(target=self._read, daemon=True).start()

    def close(self):
        self._websocket.close()

    def show(self):
        """Send the pose of the camera, with which a browser begins to show the page."""
        self.send(type='ViewerCameraMessage', **CAMERA)

    def hold(self, label):
        self.send(type='GuiButtonHoldMessage', uuid=self.find(label), frequency=10.0)

    def set(self, label, value):
        """Give an input another value; True clicks a button."""
        self.send(type='GuiUpdateMessage', uuid=self.find(label), updates={'value': value})

    def send(self, **message):
        self._websocket.send(msgspec.msgpack.encode(message))

    def find(self, label):
        """Return the id of an input once the page shows it."""
        return wait_until(lambda: next((uuid for uuid, shown in list(self._shown.items())
                                        if shown.get('label') == label and shown.get('visible')), None),
                          TIMEOUT, lambda: f'{label!r} in the page, which has {self._shown}')

    def wait_for_text(self, text):
        wait_until(lambda: any(text in shown.get('content', '') for shown in list(self._shown.values())),
                   TIMEOUT, lambda: f'{text!r} in the page, which has {self._shown}')

    def _read(self):
        with contextlib.suppress(ConnectionClosed):
            for data in self._websocket:
                for message in _decode(data)['messages']:
                    if 'uuid' in message:
                        changed = message.get('props') or message.get('updates') or {}
                        self._shown.setdefault(message['uuid'], {}).update(changed)


def _decode(data):
    length = int.from_bytes(data[8:HEADER], 'little')
    packed = zstandard.ZstdDecompressor().decompress(data[HEADER:HEADER + length])
    return msgspec.msgpack.decode(packed)


@contextlib.contextmanager
def open_page(view):
    with contextlib.closing(PageClient(view.port, origin=view.url)) as page:
        page.show()
        page.find('robot')
        yield page


@contextlib.contextmanager
def published(namespace):
    publishers = [rospy.Publisher(f'{namespace}/{robot}/odom', Odometry, queue_size=1, latch=True)
                  for robot in ROBOTS]
    for publisher in publishers:
        publisher.publish(odometry(x=0.0, stamp=5.0))
    yield publishers
    for publisher in publishers:
        publisher.unregister()
