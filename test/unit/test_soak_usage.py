"""The soak finds what grows on and on, and nothing else."""

import random
import sys

import pytest
from odometry_tests.scripts import ROOT

sys.path.insert(0, str(ROOT / 'test' / 'soak'))

from checks import Violation
from usage import Usage, UsageCheck

COUNT = 400  # measurements


def measure(monkeypatch, memory, threads=lambda k: 8, files=lambda k: 20):
    """Check a process that needs so much at the k-th measurement."""
    numbers = iter(range(COUNT))
    monkeypatch.setattr(Usage, 'of', lambda pid: next(
        Usage(memory(k), threads(k), files(k)) for k in numbers))
    check = UsageCheck()
    for _ in range(COUNT):
        check.check({'node': 1})


@pytest.mark.parametrize('leak', [
    {'memory': lambda k: 50 + 0.05 * k},
    {'memory': lambda k: 50, 'threads': lambda k: 8 + k // 40},
    {'memory': lambda k: 50, 'files': lambda k: 20 + k // 25}])
def test_a_leak_is_found(monkeypatch, leak):
    """A megabyte in 20 measurements, a thread in 40, a file in 25."""
    with pytest.raises(Violation, match='of node grow'):
        measure(monkeypatch, **leak)


def test_what_an_allocator_keeps_is_no_leak(monkeypatch):
    """Two large steps for good, and what comes and goes."""
    rng = random.Random(1)
    measure(monkeypatch, lambda k: 50 + 20 * (k > 100) + 30 * (k > 250) + rng.uniform(0, 9),
            lambda k: 8 + rng.randrange(6), lambda k: 20 + rng.randrange(12))
