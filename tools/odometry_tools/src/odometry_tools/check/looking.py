"""Looks at a scenario as often as it takes to judge the node, and not its luck or the machine."""

from odometry_tools.check.judging import judge
from odometry_tools.check.runner import SLOWEST

LOOKS = 3


def look(runner, scenario, exercise, name):
    """Return the measures of a Scenario, run as often as that needs, and the Rule that holds."""
    looks, run = 1, runner.run(scenario)
    m, held = judge(run, exercise, name)
    while _may_be_luck(m) and looks < LOOKS:
        looks, run = looks + 1, runner.run_again(scenario)
        m, held = judge(run, exercise, name)
    run.looks = looks
    if not m.passed and looks == 1 and run.interrupted is None and not m.is_silent and m.is_finite:
        if runner.follows_wall is None:
            runner.follows_wall = not run.is_like(runner.run_again(scenario))
        run.follows_wall = runner.follows_wall
        m, held = judge(run, exercise, name)
    return m, held


def _may_be_luck(m):
    """Return whether a right node may fail like this, rarely or on a busy machine.

    A pace may be too fast for it; what it publishes as it ends can be lost; rospy's own handler of
    Ctrl-C can lock itself out; a node that ends at once may do so between two looks at the graph.
    """
    if m.passed:
        return False
    return (m.run.unawaited and m.run.pace.real_time_factor > SLOWEST
            or m.rule in ('interrupt', 'interrupt_ignored')
            or m.status == 0 and m.rule in ('ceased', 'no_node'))
