"""File handles: rospy takes one for each topic and one for each connection."""

import errno
import os
import resource


def take_all_handles():
    """Let this process open as many files as it may, and not just as many as is usual."""
    _, most = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (most, most))


def shortage(error):
    """Return in words why an exception comes of a lack of file handles; None if it does not."""
    if not _is_shortage(error) and not _is_shortage(_try_one()):
        return None
    most, _ = resource.getrlimit(resource.RLIMIT_NOFILE)
    return f'no file handle is left; {most} are allowed (ulimit -n): allow more, or start less'


def _is_shortage(error):
    return isinstance(error, OSError) and error.errno in (errno.EMFILE, errno.ENFILE)


def _try_one():
    """Take a file handle and let go of it; return the error if there is none."""
    try:
        os.close(os.open(os.devnull, os.O_RDONLY))
    except OSError as error:
        return error
    return None
