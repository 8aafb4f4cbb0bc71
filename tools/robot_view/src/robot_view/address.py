"""The page's parameters, and from them its address and host names; needs no viser."""

import errno
import os
import re
import socket
from typing import NamedTuple

from odometry_common.parameters import Parameter, ParameterError, Parameters

# The container sets it, so that the page listens on the container's interface.
HOST_VARIABLE = 'ODOMETRY_VIEW_HOST'
ADDRESSES = 'a name or an address of this machine'
LOOPBACK = {'localhost', '127.0.0.1', '[::1]'}
ANY_ADDRESS = {'0.0.0.0', '::'}
HOST = re.compile(r'(\[[0-9a-f:.]+\]|[a-z0-9][a-z0-9._-]*)(:(?P<port>[0-9]+))?')
PORTS = range(1, 65536)

PARAMETERS = Parameters(
    Parameter('~port', 8080, 'port of the page', '', 'from 1 to 65535'),
    Parameter('~host', 'localhost',
              'name or address to listen on; 0.0.0.0 lets the whole network in; the environment '
              f'variable {HOST_VARIABLE} sets the default'),
    Parameter('~allowed_hosts', '',
              'further names of the page, for a proxy, such as robots.example, lab:9000; without a '
              'port, any port'),
    Parameter('~target', 0.0,
              'where the mover stops, ahead of its start; negative: behind; 0: not shown', 'm'),
    Parameter('~heading_target', 0.0,
              'heading to turn to, until rotate_robot/target tells another; 0: not shown',
              'degrees'))


class Address(NamedTuple):
    """The address on which the page listens, and its host names."""

    ip: str
    port: int
    url: str  # for a browser on this machine
    names: set  # in lower case; with a port, a name is valid with that port only
    origins: set  # of the page where it is forwarded, beside http:// and https:// of each name


def read_address(source=None):
    """Return the Address; raise ParameterError if the page cannot listen on it.

    :param source: as for Parameters.read()
    """
    parameters = PARAMETERS.read(source, host=os.environ.get(HOST_VARIABLE) or 'localhost')
    host, port = parameters.host, parameters.port
    shown = f'[{host}]' if ':' in host else host
    names = {*LOOPBACK, shown.lower(), *_parse(parameters.allowed_hosts)}
    if host in ANY_ADDRESS:
        names.add(socket.gethostname().lower())
        shown = 'localhost'
    # GitHub Codespaces forward the port by this name.
    name, domain = map(
        os.environ.get, ('CODESPACE_NAME', 'GITHUB_CODESPACES_PORT_FORWARDING_DOMAIN'))
    forwarded = {f'{name}-{port}.{domain}'.lower()} if name and domain else set()
    return Address(_find_ip(host, port), port, f'http://{shown}:{port}', names | forwarded,
                   {f'https://{name}' for name in forwarded})


def _parse(allowed_hosts):
    hosts = [host for host in re.split(r'[,\s]+', allowed_hosts.lower()) if host]
    found = [HOST.fullmatch(host) for host in hosts]
    if not all(host and int(host['port'] or PORTS[0]) in PORTS for host in found):
        raise ParameterError('~allowed_hosts', allowed_hosts, 'host names or addresses, each with '
                             'or without a port, separated by commas or spaces')
    return hosts


def _find_ip(host, port):
    """Return a free address of the host; viser would silently take another port."""
    try:
        found = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE)
    except (OSError, UnicodeError):  # UnicodeError: an empty label, or one of over 63 characters
        raise ParameterError('~host', host, ADDRESSES) from None
    family, *_, address = min(found)
    try:
        socket.create_server(address, family=family).close()
    except OSError as error:
        if error.errno == errno.EADDRNOTAVAIL:
            raise ParameterError('~host', host, ADDRESSES) from None
        raise ParameterError('~port', port, f'a free port ({error.strerror})') from None
    return address[0]
