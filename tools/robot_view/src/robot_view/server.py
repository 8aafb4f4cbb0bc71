"""The page's web server: viser's, made to refuse other pages' connections, and send our head.html.

viser has no option for these. It calls websockets.asyncio.server.serve(), so start_server() adds
serve()'s documented parameters to that call.
"""

import atexit
import functools
import gzip
import http
import re
import warnings
from pathlib import Path

import rich
import rospy
import viser
from odometry_common.parameters import StartError
from websockets.asyncio import server

LOG_PERIOD = 10.0  # s, between two lines
LOG_LENGTH = 100  # characters of a header
HEAD = Path(__file__).with_name('head.html')


def start_server(address):
    """Return a viser.ViserServer at a free Address; it runs until the process exits.

    :raises StartError: if this version of viser starts its server in another way
    """
    # viser prints its start and its end through rich, even if it is not verbose.
    rich.get_console().quiet = True
    # A browser may close at any moment, even during a write to it.
    warnings.filterwarnings('ignore', 'Queued a .* on a closed connection')
    serve, calls = server.serve, []

    def guarded_serve(*arguments, process_request, **options):
        calls.append(arguments)
        return serve(*arguments, process_response=_forbid_framing, **options,
                     process_request=functools.partial(_admit, address, process_request))

    server.serve = guarded_serve
    try:
        started = viser.ViserServer(address.ip, address.port, label='TurtleBot 2', verbose=False)
    finally:
        server.serve = serve
    if not calls:
        raise StartError('this version of viser starts its server in another way than that in '
                         'tools/robot_view/requirements.txt: pip install -r it')
    # At exit viser would wait for busy browsers for seconds.
    atexit.unregister(started.stop)
    return started


def _admit(address, process_request, connection, request):
    """Answer 403, unless the request is the page's own."""
    # A header that occurs twice is joined, and then matches nothing.
    host, origin = (', '.join(request.headers.get_all(name)) for name in ('Host', 'Origin'))
    if is_own({*address.names, connection.local_address[0]}, host, origin, address.origins):
        return _with_head(process_request(connection, request))
    rospy.logwarn_throttle(LOG_PERIOD, (
        f'refused a connection with the Host header {host!a:.{LOG_LENGTH}} and the Origin header '
        f'{origin!a:.{LOG_LENGTH}}; ~allowed_hosts adds names of this page'))
    return connection.respond(http.HTTPStatus.FORBIDDEN, 'This is not an address of the page.\n')


def _with_head(response):
    """Add HEAD to the head of viser's page; other responses, or None, stay as they are."""
    if not response or not response.headers.get('Content-Type', '').startswith('text/html'):
        return response
    is_zipped = response.headers['Content-Encoding'] == 'gzip'
    page = gzip.decompress(response.body) if is_zipped else response.body
    page = page.replace(b'<head>', b'<head>' + HEAD.read_bytes(), 1)
    response.body = gzip.compress(page) if is_zipped else page
    del response.headers['Content-Length']
    response.headers['Content-Length'] = str(len(response.body))
    return response


def is_own(names, host, origin, origins=()):
    """Return whether the page itself sent a request, by two headers that no script can change.

    Origin is the address of the page that connects. That of another page differs from the Host to
    which it connects; after DNS rebinding both are equal, but no name of this page. Any port is
    valid, since `ssh -L 9000:localhost:8080` changes it.

    :param names: host names of the page
    :param host: the Host header
    :param origins: addresses from which a proxy forwards the page to one of the names
    :param origin: the Origin header; '' if there is none, as from a program that is no browser
    """
    host = host.lower()
    name = re.sub(r':\d+$', '', host)
    is_known = not names.isdisjoint({host, name, name.strip('[]')})
    return is_known and origin.lower() in ('', f'http://{host}', f'https://{host}', *origins)


def _forbid_framing(_, __, response):
    # Another page could show this one in an invisible frame, and the user's clicks would drive.
    response.headers['Content-Security-Policy'] = "frame-ancestors 'self'"
