"""Read messages from a bag with the installed classes only.

rosbag generates a class from each message definition in a bag, and what a stranger writes in a
definition would run as Python.
"""

import rosbag
import rosbag.bag
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from std_msgs.msg import Float64

BYTES, PLACE = 1, 3  # in a raw message of rosbag
INSTALLED = {kind._md5sum: kind for kind in (Float64, Odometry, Twist)}


def _installed_class(connection):
    """Return the class of a connection's messages, in place of one that rosbag would generate."""
    try:
        return INSTALLED[connection.md5sum]
    except KeyError:
        raise rosbag.ROSBagException(f'a message is of the type {connection.datatype}') from None


rosbag.bag._get_message_type = _installed_class


def types_in(bag):
    """Return the types of a bag's topics by name, also of those without messages."""
    return {name: topic.msg_type for name, topic in bag.get_type_and_topic_info().topics.items()}


def read_messages(bag, kind, topic):
    """Return topic, message and timestamp of the messages of an INSTALLED class on a topic.

    In the order in which they were written: after a reset of simulated time earlier times follow.
    """
    def is_installed(_topic, datatype, md5sum, *_):
        return (datatype, md5sum) == (kind._type, kind._md5sum)

    def place_of(entry):
        return entry.message[PLACE]

    def with_message(entry):
        return entry._replace(message=kind().deserialize(entry.message[BYTES]))

    entries = bag.read_messages(topic, connection_filter=is_installed, raw=True)
    return [*map(with_message, sorted(entries, key=place_of))]


def differing_definitions(bag):
    """Return the topics whose type has the name of a class of INSTALLED, but another definition."""
    by_name = {kind._type: md5sum for md5sum, kind in INSTALLED.items()}
    return {connection.topic for connection in bag._get_connections()
            if connection.md5sum != by_name.get(connection.datatype, connection.md5sum)}
