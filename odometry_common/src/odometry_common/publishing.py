"""Publishers that send each message at once."""

import warnings

import rospy


def advertise(topic, message_class, queue_size=None):
    """Return a rospy.Publisher that holds no message back.

    :param queue_size: None: publish() returns when the message has been written to every
        subscriber's socket. There is no thread to hand it to, which makes the way to the
        subscriber a third shorter. A subscriber that has stopped reading stops the publisher
        too, but only once its socket is full, with some 3 MB.
        A number: a queue per subscriber, which loses the oldest messages instead.
    """
    with warnings.catch_warnings():
        # rospy takes a publisher without a queue for an oversight; here it may be meant.
        warnings.simplefilter('ignore', SyntaxWarning)
        return rospy.Publisher(topic, message_class, tcp_nodelay=True, queue_size=queue_size)
