"""The names of the page: which Host and Origin headers are its own."""

import re
import socket
from typing import NamedTuple

LOOPBACK = {'localhost', '127.0.0.1', '::1'}
ANY_ADDRESS = {'0.0.0.0', '::'}
DEFAULT_PORTS = {'http': 80, 'https': 443}
SHOWN_LENGTH = 60  # characters of a header
FORM = re.compile(r'(?:\[([0-9a-f:.]+)\]|([a-z0-9][a-z0-9._-]*))(?::([0-9]{1,5}))?')


class Host(NamedTuple):
    """A host as a Host header or a URL names it."""

    name: str  # or address, without brackets
    port: int  # None: not said, or any


def parse_host(text):
    """Return the Host in such as robots.example, lab:9000 or [::1]:8080; None if it is not one."""
    match = FORM.fullmatch(text.lower())
    if not match:
        return None
    address, name, port = match.groups()
    if port and not 1 <= int(port) <= 65535:
        return None
    return Host(address or name, port and int(port))


def parse_hosts(text):
    """Return the hosts in a text, separated by commas or spaces.

    :raises ValueError: if one of them is not a host
    """
    hosts = tuple(parse_host(part) for part in re.split(r'[,\s]+', text) if part)
    if None in hosts:
        raise ValueError(text)
    return hosts


class OwnHosts:
    """Decides whether a connection comes from the page itself.

    A browser sends two headers that no script can change. Origin names the page that connects: of
    another page it differs from the Host that it connects to. Host is the name by which this
    machine was found: an attacker's page passes for the page's own if the attacker's name resolves
    to this machine (DNS rebinding), but then the Host is that name.

    Of loopback names, ~host and the machine's own any port will do: `ssh -L 9000:localhost:8080`
    makes the page localhost:9000, while a page of another port still has another Origin.
    """

    def __init__(self, host, allowed=()):
        """Take the host that the page listens on, and further names of the page."""
        names = {*LOOPBACK, host.lower()}
        if host in ANY_ADDRESS:
            names.add(socket.gethostname().lower())
        self._hosts = {*(Host(name, None) for name in names), *allowed}

    def objection(self, hosts, origins, reached):
        """Return why a connection is not the page's own; None if it is.

        :param hosts, origins: values of these headers, each usually once or not at all
        :param reached: address of this machine at which the connection has come in
        """
        host = parse_host(hosts[0]) if len(hosts) == 1 else None
        if not host or not ({host, Host(host.name, None)} & self._hosts or host.name == reached):
            return (f'its Host header is "{_shown(hosts)}", which is not a name of this page; '
                    '~allowed_hosts adds names')
        if origins and not (len(origins) == 1 and _is_page_of(origins[0], host)):
            return (f'its Origin header is "{_shown(origins)}", which is not the page at its Host '
                    f'header, "{_shown(hosts)}"')
        return None


def _shown(values):
    return ', '.join(values)[:SHOWN_LENGTH]


def _is_page_of(origin, host):
    scheme, _, rest = origin.partition('://')
    page, default = parse_host(rest), DEFAULT_PORTS.get(scheme)
    return bool(page and default) and (
        (page.name, page.port or default) == (host.name, host.port or default))
