"""The guard of the page's port: it admits only the page itself, and only messages of a page.

viser accepts every connection and every message. It makes its server with
websockets.asyncio.server.serve(), which has documented parameters for what is needed here:
process_request may answer 403, and create_connection makes connections that may drop messages. So
while viser starts, serve() is called with these as well; nothing inside viser or websockets is
changed, and no connection can come earlier.
"""

import contextlib
import functools
import http

import rospy
from odometry_common.parameters import StartError
from websockets.asyncio import server

MAX_MESSAGE = 65536  # bytes; a page says less than a kilobyte at a time
LOG_PERIOD = 10.0  # s, between two lines of a kind
LOG_LENGTH = 250  # characters; they may come from a stranger


class GuardedConnection(server.ServerConnection):
    """A websocket that passes on accepted messages only."""

    def __init__(self, check, *arguments, **options):
        """Take a function that returns a message as it may be passed on, or raises ValueError."""
        super().__init__(*arguments, **options)
        self._check = check

    async def recv(self, decode=None):
        """Return the next message that is accepted."""
        while True:
            try:
                return self._check(await super().recv(decode))
            except ValueError as error:
                rospy.logwarn_throttle(LOG_PERIOD, f'ignored from a page: {_printable(error)}')


@contextlib.contextmanager
def guarded(hosts, check):
    """Return a context in which viser has to make its server.

    :param hosts: OwnHosts
    :param check: see GuardedConnection
    :raises StartError: at the end, if it has not made a guarded one
    """
    serve, served = server.serve, []

    def guarded_serve(*arguments, process_request, **options):
        served.append(True)
        options.update(process_request=functools.partial(_let_in, hosts, process_request),
                       process_response=_forbid_framing, max_size=MAX_MESSAGE,
                       create_connection=functools.partial(GuardedConnection, check))
        return serve(*arguments, **options)

    server.serve = guarded_serve
    try:
        yield
    finally:
        server.serve = serve
    if not served:
        raise StartError('this version of viser makes its server in another way than that in '
                         'sim_turtlebot/requirements-view.txt: pip install -r it')


def _let_in(hosts, process_request, connection, request):
    """Answer 403 unless the request is the page's own, which viser answers."""
    objection = hosts.objection(request.headers.get_all('Host'), request.headers.get_all('Origin'),
                                connection.local_address[0])
    if objection is None:
        return process_request(connection, request)
    rospy.logwarn_throttle(LOG_PERIOD, f'a connection was refused: {_printable(objection)}')
    return connection.respond(http.HTTPStatus.FORBIDDEN, 'This is not an address of the page.\n')


def _forbid_framing(_, __, response):
    # In an invisible frame of another page, clicks meant for that page would drive.
    response.headers['Content-Security-Policy'] = "frame-ancestors 'self'"


def _printable(words):
    return ascii(str(words))[1:-1][:LOG_LENGTH]
