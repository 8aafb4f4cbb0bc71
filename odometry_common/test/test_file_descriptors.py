"""Whether an exception comes of a lack of file handles."""

import errno
import os
import resource

import pytest
from odometry_common.handles import shortage


@pytest.fixture
def no_handles():
    """Have this process open no more files."""
    before = resource.getrlimit(resource.RLIMIT_NOFILE)
    next_one = os.open(os.devnull, os.O_RDONLY)
    os.close(next_one)
    resource.setrlimit(resource.RLIMIT_NOFILE, (next_one, before[1]))
    yield
    resource.setrlimit(resource.RLIMIT_NOFILE, before)


@pytest.mark.parametrize('number', [errno.EMFILE, errno.ENFILE])
def test_an_exception_may_say_so(number):
    """Also when a handle is free again."""
    assert 'no file handle is left' in shortage(OSError(number, 'Too many open files'))


@pytest.mark.parametrize('error', [OSError(errno.EBADF, 'closed'), ImportError(), KeyError(24)])
def test_another_exception_comes_of_it_if_there_is_none(error, no_handles):
    """As of a module that cannot be opened."""
    assert 'no file handle is left' in shortage(error)


@pytest.mark.parametrize('error', [OSError(errno.EBADF, 'closed'), ImportError(), KeyError(24)])
def test_with_handles_left_it_comes_of_something_else(error):
    """And is reported as ever."""
    assert shortage(error) is None
