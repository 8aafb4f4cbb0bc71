"""What a command that runs on has to show before its reader goes on."""

import contextlib
import re
from pathlib import Path

import rosgraph
from roslaunch.arg_dump import get_args

from odometry_tests.links import HEARS, links
from odometry_tests.scripts import ROOT

NAME = '/documents'
NEEDS_PUBLISHER = re.compile(r'/(odom|moved_distance)$')
NEEDS_SUBSCRIBER = re.compile(r'/(cmd_vel|commands/velocity)$')
LAUNCHED = re.compile(r'^    (\S+) \(\S+/\S+\)$')
LAUNCH_NAMESPACE = re.compile(r'^  (/\S*)$')


class Graph:
    """The nodes and topics of a ROS master, wherever it is."""

    def __init__(self, address):
        """Take the master's address; it need not run yet."""
        self._address = address
        self._master = rosgraph.Master(NAME, address)

    @property
    def is_up(self):
        """Whether the master answers."""
        return self._master.is_online()

    def nodes(self):
        """Return the names of all nodes."""
        return {node for topics in self._state() for _, nodes in topics for node in nodes}

    def publications(self, node=None):
        """Return the topics that a node, or anybody, publishes."""
        return _topics_of(self._state()[0], node)

    def subscriptions(self, node=None):
        """Return the topics that a node, or anybody, listens to."""
        return _topics_of(self._state()[1], node)

    def services(self):
        """Return the names of all services."""
        return {name for name, _ in self._state()[2]}

    def hears(self, node):
        """Return whether a node is connected with somebody it listens to, beside the clock."""
        with contextlib.suppress(rosgraph.MasterError, OSError):  # until the node answers
            return any(link.topic != '/clock' for link in links(node, HEARS, self._address))

    def types(self):
        """Return the type of each topic."""
        return dict(self._master.getTopicTypes())

    def has_parameter(self, name):
        """Return whether somebody has set a parameter."""
        return self._master.hasParam(rosgraph.names.resolve_name(name, NAME))

    def _state(self):
        return self._master.getSystemState() if self.is_up else ([], [], [])


def _topics_of(topics, node):
    return {topic for topic, nodes in topics if node is None or node in nodes}


def lacks(words, terminal, graph, nodes_before):
    """Return what a running command has not shown yet, or None if it is at work."""
    if words[0] == 'roscore':
        return None if '/rosout' in graph.nodes() else 'the node /rosout'
    if words[0] in ('rosrun', 'python3'):
        new = graph.nodes() - nodes_before
        if len(new) != 1:
            return f'one new node in place of {sorted(new)}'
        # A node of bare rospy may hang if Ctrl-C comes while it registers a topic. Who answers
        # messages subscribes last.
        if words[0] == 'python3' and not graph.hears(*new):
            return f'a message to {sorted(new)}'
        return _lacks_partner(new, graph) or _ignores_remapping(words, *new, graph)
    if words[0] == 'roslaunch':
        launched = _launched(terminal.lines)
        missing = launched - graph.nodes()
        if missing or not launched:
            return f'the nodes {sorted(missing)} of {sorted(launched)}'
        return _lacks_partner(launched, graph)
    if words[:2] == ['rostopic', 'echo']:
        return None if '---' in terminal.lines else 'a message'
    if words[:2] == ['rostopic', 'pub'] and words[2].startswith('-r'):
        return None if words[3] in graph.publications() else f'a publisher of {words[3]}'
    if words[:2] == ['rosbag', 'record']:
        return None if 'Recording to' in terminal.output else 'that it records'
    if words[:2] == ['./ws', 'demo']:
        return None if re.search(r'\[=* *\] ', terminal.output) else 'a line of progress'
    return 'its end'


def _launched(lines):
    """Return the names of the nodes in the summary that roslaunch prints."""
    names, namespace = set(), None
    for line in lines:
        if found := LAUNCH_NAMESPACE.match(line):
            namespace = found[1]
        elif namespace and (found := LAUNCHED.match(line)):
            names.add(namespace + found[1])
    return names


def _lacks_partner(nodes, graph):
    """Return the topic on which a node talks to itself."""
    for node in nodes:
        alone = {topic for topic in graph.subscriptions(node) - graph.publications()
                 if NEEDS_PUBLISHER.search(topic)}
        alone |= {topic for topic in graph.publications(node) - graph.subscriptions()
                  if NEEDS_SUBSCRIBER.search(topic)}
        if alone:
            return f'a partner of {node} on {sorted(alone)}'
    return None


def _ignores_remapping(words, node, graph):
    topics = graph.publications(node) | graph.subscriptions(node)
    topics &= graph.publications() & graph.subscriptions()
    for word in words:
        _, separator, target = word.partition(':=')
        if separator and not word.startswith('_') and f'/{target}' not in topics:
            return f'{target} among what {node} shares with others: {sorted(topics)}'
    return None


def objection(words, graph):
    """Return what makes a command senseless that would end well all the same, or None."""
    if words[0] == 'roslaunch':
        return _unknown_argument(words)
    if words[:2] == ['rostopic', 'pub']:
        topic, kind = words[3:5]
        if topic not in graph.subscriptions() or graph.types().get(topic) != kind:
            return f'nobody listens to {topic} with {kind}'
    if words[:2] == ['rosservice', 'call'] and words[2] not in graph.services():
        return f'there is no service {words[2]}'
    if words[:2] == ['rosparam', 'set'] and not graph.has_parameter(words[2]):
        return f'there is no parameter {words[2]}'
    return None


def _unknown_argument(words):
    files = [Path(ROOT, 'launch', word) for word in words if word.endswith('.launch')]
    known = get_args([str(file) for file in files if file.exists()])
    for word in words:
        name, separator, _ = word.partition(':=')
        if separator and name not in known:
            return f'there is no launch argument {name}'
    return None
