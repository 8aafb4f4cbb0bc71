"""What tests ask of Linux, and not every system offers."""

import os
from pathlib import Path

import pytest

needs_children = pytest.mark.skipif(
    not Path(f'/proc/self/task/{os.getpid()}/children').exists(),
    reason='this system does not list the children of a process in /proc')
