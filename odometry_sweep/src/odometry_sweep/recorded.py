"""Read a run by nodes from its bag."""

import rosbag
from odometry_launch.output import DemoError
from odometry_launch.recording import COMMANDS
from sim_turtlebot.robot.odometry import Motion

TOPICS = '/odom', '/base_pose_ground_truth', '/moved_distance'


def read(bag_file):
    """Return ticks as for closed_loop.follow(), distances of the detector, and how many commands were sent.

    :raises DemoError: if the bag cannot be read, or has gaps
    """
    try:
        with rosbag.Bag(str(bag_file)) as bag:
            odometry, ground_truth, moved = (
                [message for _, message, _ in bag.read_messages(topic)] for topic in TOPICS)
            commands = bag.get_message_count([f'/{topic}' for topic in COMMANDS])
    except (OSError, rosbag.ROSBagException) as error:
        raise DemoError(f'{bag_file} cannot be read: {error}') from None
    ticks = [(seen.header.stamp.to_sec(), _motion(seen), _motion(true))
             for seen, true in zip(_in_order(odometry), _in_order(ground_truth))]
    return ticks, [message.data for message in moved], commands


def _in_order(messages):
    """Return the messages; raise DemoError if one is missing."""
    if not messages or [message.header.seq for message in messages] != [*range(len(messages))]:
        raise DemoError('the recording has gaps')
    return messages


def _motion(message):
    pose, twist = message.pose.pose, message.twist.twist
    position, orientation, linear, angular = (
        tuple(getattr(part, name) for name in part.__slots__)
        for part in (pose.position, pose.orientation, twist.linear, twist.angular))
    return Motion(position, orientation, linear, angular)
