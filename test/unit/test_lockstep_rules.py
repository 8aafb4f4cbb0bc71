"""Lockstep: the simulation waits for controllers that have not answered."""

import math

from hypothesis import example, given
from hypothesis import strategies as st
from sim_turtlebot.lockstep import Lockstep

usual_rates = st.sampled_from([(10, 240), (20, 240), (1, 240), (50, 250), (7, 245), (1000, 1000)])
any_rates = st.tuples(st.floats(0.1, 1000), st.floats(240, 1100)).filter(lambda r: r[0] <= r[1])


def last_step_before(multiple, rate, step_rate):
    """Return the last step that does not pass a multiple of 1/rate; as exact as floats are."""
    return math.floor(multiple * step_rate / rate + 1e-6)


def drive(lockstep, steps, answer):
    """Simulate from step to step; return the steps that had to wait, each once."""
    waits = []
    for step in steps:
        if lockstep.must_wait(step):
            waits.append(step)
            answer(step)
            assert not lockstep.must_wait(step)
    return waits


@given(st.one_of(usual_rates, any_rates))
def test_who_goes_from_one_last_step_to_the_next_waits_as_often(rates):
    """The steps between them need not be asked for, and there is always one to take."""
    rate, step_rate = rates
    lockstep = Lockstep(rate, step_rate, controllers=1)
    steps, waits = 0, []
    while steps < 500:
        if lockstep.must_wait(steps):
            waits.append(steps)
            lockstep.heard(0)
        assert not lockstep.must_wait(steps)
        assert lockstep.last_step > steps
        steps = lockstep.last_step
    each = Lockstep(rate, step_rate, controllers=1)
    assert waits == drive(each, range(500), lambda _: each.heard(0))


@given(st.one_of(usual_rates, any_rates))
@example((11, 240))  # 11 * (240 / 11) is rounded to less than 240
def test_each_multiple_waits_for_a_command_once(rates):
    """A controller that answers when it is waited for holds each multiple up, and only those."""
    rate, step_rate = rates
    lockstep = Lockstep(rate, step_rate, controllers=1)
    waits = drive(lockstep, range(500), lambda _: lockstep.heard(0))
    multiples = range(math.ceil(500 * rate / step_rate) + 1)
    expected = {last_step_before(multiple, rate, step_rate) for multiple in multiples}
    assert waits == sorted(step for step in expected if step < 500)


@given(st.one_of(usual_rates, any_rates), st.lists(st.integers(0, 300), max_size=20))
def test_no_multiple_is_passed_without_a_command_since_the_last(rates, pauses):
    """Whenever commands come: the law of the lockstep."""
    rate, step_rate = rates
    lockstep = Lockstep(rate, step_rate, controllers=1)
    passes = {last_step_before(multiple, rate, step_rate) for multiple in range(6001)}
    step, heard = 0, False
    for pause in pauses:
        for _ in range(pause):
            if not lockstep.must_wait(step):
                assert heard or step not in passes
                heard = heard and step not in passes
                step += 1
        lockstep.heard(0)
        heard = True


def test_time_stands_still_until_the_first_command():
    """At time zero, before any step."""
    lockstep = Lockstep(10, 240, controllers=1)
    assert not lockstep.started
    assert lockstep.must_wait(0)
    lockstep.heard(0)
    assert lockstep.started
    assert not lockstep.must_wait(0)


def test_a_command_ahead_of_time_counts_for_one_multiple_only():
    """Ten commands before a multiple are no licence to pass ten."""
    lockstep = Lockstep(10, 240, controllers=1)
    for _ in range(10):
        lockstep.heard(0)
    waits = drive(lockstep, range(100), lambda _: lockstep.heard(0))
    assert waits == [24, 48, 72, 96]


def test_several_controllers_are_all_waited_for():
    """One that speaks twice does not speak for the other."""
    lockstep = Lockstep(10, 240, controllers=2)
    lockstep.heard(0)
    lockstep.heard(0)
    assert lockstep.must_wait(0)
    lockstep.heard(1)
    assert not lockstep.must_wait(0)


def test_who_has_never_spoken_is_given_up_without_a_word():
    """Two robots, one controller: the wait at time zero is the only one for the other."""
    lockstep = Lockstep(10, 240, controllers=2)
    lockstep.heard(0)
    assert lockstep.must_wait(0)
    assert not lockstep.give_up()
    assert drive(lockstep, range(100), lambda _: lockstep.heard(0)) == [24, 48, 72, 96]


def test_who_falls_silent_is_given_up_once_and_comes_back_by_speaking():
    """Time goes on without the controller, and in step again from the next multiple."""
    lockstep = Lockstep(10, 240, controllers=1)
    lockstep.heard(0)
    losses = []
    assert drive(lockstep, range(72), lambda _: losses.append(lockstep.give_up())) == [24]
    assert losses == [True]
    lockstep.heard(0)
    assert drive(lockstep, range(72, 121), lambda _: lockstep.heard(0)) == [96, 120]


def test_a_silent_controller_does_not_free_the_others():
    """Of two, the one that still speaks is still waited for."""
    lockstep = Lockstep(10, 240, controllers=2)
    lockstep.heard(0)
    lockstep.heard(1)
    assert not lockstep.must_wait(0)
    lockstep.heard(0)
    assert lockstep.must_wait(24)
    assert lockstep.give_up()
    assert drive(lockstep, range(24, 100), lambda _: lockstep.heard(0)) == [48, 72, 96]


def test_after_a_restart_time_zero_waits_for_a_command_again():
    """A command from before the reset is no answer to what came after it."""
    lockstep = Lockstep(10, 240, controllers=1)
    drive(lockstep, range(60), lambda _: lockstep.heard(0))
    lockstep.heard(0)
    lockstep.restart()
    assert lockstep.started
    assert drive(lockstep, range(60), lambda _: lockstep.heard(0)) == [0, 24, 48]
