"""What a node's documentation says of its parameters."""

from odometry_common.usage import parameters

DOCUMENTATION = """Do something.

Services:
    ~pause (std_srvs/Empty): not a parameter

Parameters:
    ~x, ~y, ~yaw (float, 0.0 m): where; ~x is
        ~not (a parameter)
    ~rate (float, 10 Hz): how often

It ends with ~prose (really).
"""


def test_the_parameters_are_those_that_are_listed():
    """In their order; several may share a line."""
    assert parameters(DOCUMENTATION) == ['~x', '~y', '~yaw', '~rate']


def test_a_node_may_have_none():
    """Or no documentation at all."""
    assert parameters('Print the heading.') == []
    assert parameters('') == []
