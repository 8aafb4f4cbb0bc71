"""Lockstep waits for what nodes start."""

import os
import types

import pytest
from sim_turtlebot.lockstep.children import Children


@pytest.fixture
def waits():
    return []


@pytest.fixture
def children(waits):
    """Return those of no process, whose waiter only counts."""
    return Children(types.SimpleNamespace(processes={}, wait=lambda: waits.append(1)), pytest.fail)


def test_a_child_that_has_ended_may_have_woken_its_parent(children, waits):
    """Also if the ids of processes have begun anew since."""
    children._newest = children._end_of_pids
    os.system('true')
    children.await_new([])
    assert waits
