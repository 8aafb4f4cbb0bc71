"""A node that takes the name of an earlier one ends nobody else, whose port may be the same by now."""

import contextlib
from xmlrpc.client import ServerProxy

import pytest
import rosgraph
import rospy
from odometry_tests.tutorial import detector
from odometry_tests.waiting import Recorder
from rosgraph_msgs.msg import Log

REQUEST = '[{}] Reason: new node registered with same name'  # as rosmaster words it


def test_a_request_for_another_node_is_not_obeyed(master):
    """One for this node is."""
    with detector('__name:=first') as node:
        node.wait_for_output('waiting for')
        with ServerProxy(rosgraph.Master('/test').lookupNode('/first')) as address:
            assert address.shutdown('/master', REQUEST.format('/second'))[0] == 1
            with contextlib.suppress(OSError):  # it may end before it answers
                address.shutdown('/master', REQUEST.format('/first'))
        assert node.wait() == 0
    assert '/first' in node.output
    assert '/second' not in node.output


def test_the_master_forgets_a_node_that_has_ended(master):
    """Also one that has logged something, for which rospy asks the master for a parameter."""
    with detector('__name:=short') as node:
        node.wait_for_output('waiting for')
        rosgraph.Master('/test').lookupNode('/short')
        assert node.end() == 0
    with pytest.raises(rosgraph.MasterError):
        rosgraph.Master('/test').lookupNode('/short')


@pytest.mark.parametrize('disabled', [True, False])
def test_that_parameter_is_obeyed(master, disabled):
    """A line of the log comes with the node's topics, or without."""
    rospy.set_param('/rosout_disable_topics_generation', disabled)
    log = Recorder('/rosout', Log)
    name = f'/disabled_{disabled}'
    with detector(f'__name:={name[1:]}'):
        line = log.wait_for(lambda m: m.name == name and 'waiting for' in m.msg)
    assert (line.topics == []) == disabled, line
