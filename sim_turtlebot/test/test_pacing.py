"""Simulated time keeps to its share of the wall clock, and a machine that is too slow is found."""

from types import SimpleNamespace

import pytest
from sim_turtlebot.pacing import Pacer

SECOND = 10**9  # ns


@pytest.fixture
def wall(monkeypatch):
    """Give the pacers a wall clock that stands still unless the test advances it."""
    clock = SimpleNamespace(now=1000.0, monotonic=lambda: clock.now)
    monkeypatch.setattr('sim_turtlebot.pacing.time', clock)
    return clock


@pytest.mark.parametrize('factor', [0.5, 1.0, 20.0])
def test_simulated_time_keeps_to_its_share_of_wall_time(wall, factor):
    pacer = Pacer(factor)
    pacer.restart(5 * SECOND)
    assert pacer.lead(6 * SECOND) == pytest.approx(1 / factor)
    wall.now += 0.75 / factor
    assert pacer.lead(6 * SECOND) == pytest.approx(0.25 / factor)
    wall.now += 0.25 / factor
    assert pacer.lead(6 * SECOND) == pytest.approx(0, abs=1e-9)


class Machine:
    """A machine that simulates at some pace, and what its pacer says."""

    def __init__(self, wall, factor=1.0):
        self.said = []
        self._wall = wall
        self._factor = factor
        self._step = round(factor * SECOND / 100)  # ns of simulated time
        self.now = 0
        self.pacer = Pacer(factor, self.said.append)

    def run(self, duration, pace):
        """Run for so many seconds of wall time, `pace` times as fast as is wanted."""
        end = self._wall.now + duration
        while self._wall.now < end:
            lead = self.pacer.lead(self.now)
            if lead > 0.001:
                self._wall.now += lead
            else:
                self.now += self._step
                self._wall.now += self._step / SECOND / self._factor / pace


@pytest.mark.parametrize('factor', [0.5, 1.0, 100.0])
@pytest.mark.parametrize('pace', [0.01, 0.5, 0.85])
def test_a_machine_that_is_too_slow_is_told_of_once_with_its_pace(wall, factor, pace):
    machine = Machine(wall, factor)
    machine.run(600, pace)
    assert machine.said == [pytest.approx(factor * pace, rel=0.02)]


@pytest.mark.parametrize('pace', [0.95, 1.0, 20.0])
def test_a_machine_that_keeps_pace_is_not_told_of(wall, pace):
    """Nor one that sleeps an hour, or is busy for a second now and then."""
    machine = Machine(wall)
    machine.run(600, pace)
    for pause in [3600, *[1] * 50]:
        machine.run(5, pace)
        wall.now += pause
    assert not machine.said


def test_a_machine_that_has_caught_up_is_told_of_and_then_warned_of_again(wall):
    """One that keeps pace for ten seconds, or is paused, in between has not caught up."""
    machine = Machine(wall)
    for _ in range(3):
        machine.run(20, 0.5)
        machine.run(10, 10.0)
        wall.now += 3600
        machine.pacer.restart(machine.now)
    assert machine.said == [pytest.approx(0.5, rel=0.02)]
    machine.run(60, 10.0)
    assert machine.said[1:] == [None]
    machine.run(60, 0.2)
    assert machine.said[2:] == [pytest.approx(0.2, rel=0.02)]
