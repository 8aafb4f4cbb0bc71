#!/usr/bin/env python3
"""Republish what all nodes log, in place of the C++ rosout.

The C++ rosout ignores ROS_HOSTNAME and listens on all network interfaces.

Subscribes:
    /rosout (rosgraph_msgs/Log)

Publishes:
    /rosout_agg (rosgraph_msgs/Log)
"""

import rospy
from odometry_common.node import run_node, spin
from rosgraph_msgs.msg import Log


def main():
    """Republish until shutdown."""
    publisher = rospy.Publisher('/rosout_agg', Log, queue_size=100)
    rospy.Subscriber('/rosout', Log, publisher.publish)
    spin()


if __name__ == '__main__':
    # disable_rostime: it stamps nothing itself, so it does not need the clock.
    run_node('rosout', main, __doc__, disable_rostime=True)
