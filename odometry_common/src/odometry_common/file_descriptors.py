"""File descriptors: rospy opens one for each topic and one for each connection."""

import errno
import os
import resource


def raise_limit():
    """Raise the soft limit on open files to the hard limit."""
    _, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (hard, hard))


def shortage(error):
    """Return one line for the user if an exception comes of a lack of file descriptors, or None."""
    if not (_is_shortage(error) or _is_shortage(_try_one())):
        return None
    limit, _ = resource.getrlimit(resource.RLIMIT_NOFILE)
    return f'out of file descriptors (limit {limit}): raise it with ulimit -n, or start fewer nodes'


def _is_shortage(error):
    return isinstance(error, OSError) and error.errno in (errno.EMFILE, errno.ENFILE)


def _try_one():
    """Open and close a file; return the error if that fails."""
    try:
        os.close(os.open(os.devnull, os.O_RDONLY))
    except OSError as error:
        return error
    return None
