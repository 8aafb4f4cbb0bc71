"""Where the page is, read from the parameters; needs no viser."""

import errno
import os
import socket
from typing import NamedTuple

from odometry_common.parameters import ANY, Parameter, ParameterError, Parameters, between
from odometry_common.ports import bind

from robot_view.hosts import ANY_ADDRESS, OwnHosts, parse_hosts

# In a container it names the container's interface, whose port is published by whoever runs that.
HOST_VARIABLE = 'ODOMETRY_VIEW_HOST'
ADDRESSES = 'a name or an address of this machine'

PARAMETERS = Parameters(
    Parameter('~port', 8080, '', between(1, 65535), 'port of the page'),
    Parameter('~host', 'localhost', '', ANY,
              'name or address to listen on; 0.0.0.0 lets the whole network in; the environment '
              f'variable {HOST_VARIABLE} sets another default'),
    Parameter('~allowed_hosts', '', '', ANY,
              'further names of the page, where a proxy or a forwarded port gives it others, such '
              'as robots.example, lab:9000: separated by commas or spaces; without a port, any '
              'will do'))


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
    parameters = PARAMETERS.read(host=os.environ.get(HOST_VARIABLE) or 'localhost')
    host, port = parameters.host, parameters.port
    own_hosts = OwnHosts(host, _parse(parameters.allowed_hosts))
    return Address(host, _find_ip(host, port), port, own_hosts)


def _parse(allowed_hosts):
    try:
        return parse_hosts(allowed_hosts)
    except ValueError:
        raise ParameterError('~allowed_hosts', allowed_hosts, 'host names or addresses, each with '
                             'or without a port, separated by commas or spaces') from None


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
