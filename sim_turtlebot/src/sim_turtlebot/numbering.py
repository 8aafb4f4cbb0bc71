"""Messages that carry the number of the odometry period they belong to.

rospy would count the messages it sends. With our number, a message that is sent twice is the same
message, and two runs are the same bytes.
"""


def numbered(message_class):
    """Return a subclass of a message class whose header.seq rospy leaves alone."""
    return type(f'Numbered{message_class.__name__}', (message_class,), {'_has_header': False})


def publish(publisher, message, stamp, number):
    """Publish a message of a numbered() class.

    :param stamp: rospy.Time
    :param number: how many odometry periods have passed
    """
    message.header.stamp = stamp
    message.header.seq = number
    publisher.publish(message)
