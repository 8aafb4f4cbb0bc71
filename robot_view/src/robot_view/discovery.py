"""Find the robots that the ROS master knows."""

import re
from typing import NamedTuple

import rosgraph
import rospy

TARGET = 'rotate_robot/target'


class Discovery(NamedTuple):
    """The robots and services that the ROS master knows."""

    robots: list  # their namespaces, '' or such as 'robot_1/'
    rotating: set  # namespaces in which rotate.py runs
    services: set  # full names


def discover():
    """Return a Discovery; raise OSError or rosgraph.MasterException if the master is gone."""
    publications, subscriptions, services = rosgraph.Master(rospy.get_name()).getSystemState()
    published = {topic for topic, _ in publications}
    subscribed = {topic for topic, nodes in subscriptions if set(nodes) != {rospy.get_name()}}
    namespace = re.escape(rospy.get_namespace())
    numbers = [re.fullmatch(rf'{namespace}robot_(\d+)/odom', topic) for topic in published]
    robots = [f'robot_{number}/' for number in sorted(int(match[1]) for match in numbers if match)]
    if rospy.resolve_name('odom') in published:
        robots.insert(0, '')
    rotating = {robot for robot in robots if rospy.resolve_name(f'{robot}{TARGET}') in subscribed}
    return Discovery(robots, rotating, {service for service, _ in services})
