"""When a node begins under a name that another one had: nobody else has to end.

The ROS master then asks the other one to shut down, at the last address that it knows of it. By then
the address may be that of a third node, even one of another master: after a few hundred nodes the
operating system gives the same port again.
"""

import contextlib
import re

import rosgraph
import rospy
from rospy.impl.masterslave import ROSHandler
from rospy.impl.paramserver import get_param_server_cache

# In the words of rosmaster/registrations.py.
REQUEST = re.compile(r'\[(?P<name>/.+)\] Reason: new node registered with same name')
ROSOUT_PARAMETER = '/rosout_disable_topics_generation'

_rospys_shutdown = ROSHandler.shutdown


def mend_same_name():
    """Have rospy.init_node make nodes that leave no address behind, and end for their own name only.

    rospy subscribes to a parameter with its first line of the log, and never unsubscribes, so that
    the master takes each node that has ended for one that is there. Here the parameter is read
    once, at the start.
    """
    ROSHandler.shutdown = _shut_down_if_meant
    value = False
    with contextlib.suppress(OSError, rosgraph.MasterException):  # not set, or the master has ended
        value = rosgraph.Master(rospy.get_name()).getParam(ROSOUT_PARAMETER)
    get_param_server_cache().set(ROSOUT_PARAMETER, value)


def _shut_down_if_meant(handler, caller_id, reason=''):
    """Answer a request to shut down as rospy does, unless another node is meant."""
    request = REQUEST.fullmatch(reason)
    if request and request['name'] != rospy.get_name():
        return 1, f'this is {rospy.get_name()}', 0
    return _rospys_shutdown(handler, caller_id, reason)
