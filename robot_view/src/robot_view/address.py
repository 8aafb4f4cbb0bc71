"""The page's address and names, from the parameters; needs no viser."""

import errno
import os
import re
import socket
from typing import NamedTuple

from odometry_common.parameters import ParameterError, get_text, get_whole
from odometry_common.ports import bind

# A container sets it: there the page listens on the container's interface.
HOST_VARIABLE = 'ODOMETRY_VIEW_HOST'
ADDRESSES = 'a name or an address of this machine'
LOOPBACK = {'localhost', '127.0.0.1', '[::1]'}
ANY_ADDRESS = {'0.0.0.0', '::'}
HOST = re.compile(r'(\[[0-9a-f:.]+\]|[a-z0-9][a-z0-9._-]*)(:[1-9][0-9]{0,4})?')


class Address(NamedTuple):
    """Where the page listens, and the names it has there."""

    ip: str
    port: int
    url: str  # for a browser on this machine
    names: set  # in lower case; with a port, a name is valid with that port only


def read_address():
    """Return the Address; raise ParameterError if it is impossible to listen there."""
    port = get_whole('~port', 8080, 1, 65535)
    host = get_text('~host', os.environ.get(HOST_VARIABLE) or 'localhost')
    names = {*LOOPBACK, host.lower(), *_read_allowed_hosts()}
    shown = host
    if host in ANY_ADDRESS:
        names.add(socket.gethostname().lower())
        shown = 'localhost'
    return Address(_find_ip(host, port), port, f'http://{shown}:{port}', names)


def _read_allowed_hosts():
    text = get_text('~allowed_hosts', '')
    hosts = [host for host in re.split(r'[,\s]+', text.lower()) if host]
    if not all(HOST.fullmatch(host) for host in hosts):
        raise ParameterError('~allowed_hosts', text, 'host names or addresses, each with or '
                             'without a port, separated by commas or spaces')
    return hosts


def _find_ip(host, port):
    """Return an address of the host that is free; viser would silently take another port."""
    try:
        found = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE)
    except OSError:
        raise ParameterError('~host', host, ADDRESSES) from None
    family, *_, address = min(found)
    try:
        bind(address, family).close()
    except OSError as error:
        if error.errno == errno.EADDRNOTAVAIL:
            raise ParameterError('~host', host, ADDRESSES) from None
        allowed = f'a port that can be listened on ({error.strerror})'
        raise ParameterError('~port', port, allowed) from None
    return address[0]
