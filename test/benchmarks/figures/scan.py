"""The unpaced graph with the default scan and a subscriber of it, beside real time."""

import rospy
from graph import UNPACED, Graph
from measuring import SPEED_UNIT, Target, in_slices

NAME, UNIT, TARGET = 'graph unpaced, with a scan', SPEED_UNIT, Target('>=', 20)


def measure(options):
    with Graph(*UNPACED, '_scan:=true') as graph:
        subscriber = rospy.Subscriber('/scan', rospy.AnyMsg)
        pairs = in_slices(options, graph.speed, lambda _: 1.0)
        subscriber.unregister()
    return pairs
