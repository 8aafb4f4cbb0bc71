"""ROS's own tools know every type that the nodes use."""

import contextlib

import rosgraph
import rosservice
from odometry_tests.processes import Process
from odometry_tests.tutorial import detector, mover, rotator, simulator
from odometry_tests.waiting import TIMEOUT, wait_until

# The last that each node announces.
TOPICS = {'/moved_distance/reset', '/moved_distance', '/rotate_robot/target', '/cmd_vel'}
SERVICE = '/sim_turtlebot/reset_simulation'


def topic_types():
    """Return the type of each topic by its name."""
    return dict(rosgraph.Master('/test').getTopicTypes())


def unknown_to(tool, kinds):
    """Return what a tool prints about those of the types that it does not know."""
    shows = {kind: Process(tool, 'show', kind) for kind in sorted(kinds)}
    return {kind: show.output for kind, show in shows.items() if show.wait() != 0}


def test_every_type_of_a_topic_or_service_is_shown(simulated_time):
    """Its definition lies where ROS looks for it, with all that it is made of."""
    with contextlib.ExitStack() as stack:
        for start in simulator, detector, mover, rotator:
            stack.enter_context(start())
        wait_until(lambda: SERVICE in rosservice.get_service_list() and TOPICS <= {*topic_types()},
                   TIMEOUT, lambda: f'{SERVICE}, {TOPICS}; there are {topic_types()}')
        services = {rosservice.get_service_type(name) for name in rosservice.get_service_list()}
        assert unknown_to('rosmsg', set(topic_types().values())) == {}
        assert unknown_to('rossrv', services) == {}
