"""Where the page is, read from the parameters; needs no viser."""

import errno
import os
import socket
from typing import NamedTuple

from odometry_common.parameters import ParameterError, get_text, get_whole
from odometry_common.ports import bind

from robot_view.hosts import ANY_ADDRESS, OwnHosts, parse_hosts

# In a container it names the container's interface, whose port is published by whoever runs that.
HOST_VARIABLE = 'ODOMETRY_VIEW_HOST'
ADDRESSES = 'a name or an address of this machine'


class Address(NamedTuple):
    """A place to listen on, and the names of the page there."""

    host: str  # as given
    ip: str
    port: int
    own_hosts: OwnHosts

    @property
    def url(self):
        """Return where a browser finds the page."""
        return f'http://{"localhost" if self.host in ANY_ADDRESS else self.host}:{self.port}'


def read_address():
    """Return the Address; raise ParameterError if it is impossible to listen there."""
    port = get_whole('~port', 8080, 1, 65535)
    host = get_text('~host', os.environ.get(HOST_VARIABLE) or 'localhost')
    own_hosts = OwnHosts(host, _read_allowed_hosts())
    return Address(host, _find_ip(host, port), port, own_hosts)


def _read_allowed_hosts():
    text = get_text('~allowed_hosts', '')
    try:
        return parse_hosts(text)
    except ValueError:
        raise ParameterError('~allowed_hosts', text, 'host names or addresses, each with or '
                             'without a port, separated by commas or spaces') from None


def _find_ip(host, port):
    """Return an address of the host that can be listened on; viser would look for another port."""
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
