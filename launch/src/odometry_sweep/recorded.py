"""The figures of a run that was recorded in lockstep."""

import rosbag
from moved_distance.parameters import read_counter
from odometry_common.parameters import read_from
from odometry_launch.graph import DemoError
from sim_turtlebot.odometry import Motion

from odometry_sweep.closed_loop import Tick, follow
from odometry_sweep.reading import read


def figures_of(bag_file, tutorial, parameters):
    """Return the figures by their names; raise DemoError if the nodes did something else."""
    try:
        with rosbag.Bag(str(bag_file)) as bag:
            odometry, ground_truth, moved = (
                [message for _, message, _ in bag.read_messages(topic)]
                for topic in ('/odom', '/base_pose_ground_truth', '/moved_distance'))
    except (OSError, rosbag.ROSBagException) as error:
        raise DemoError(f'{bag_file} cannot be read: {error}') from None
    pairs = zip(_in_order(odometry), _in_order(ground_truth))
    ticks = [Tick(seen.header.stamp.to_sec(), _motion(seen), _motion(true)) for seen, true in pairs]
    if tutorial == 'move':
        _check_detector(ticks, [message.data for message in moved], parameters)
    return follow(read(tutorial, parameters)[0], ticks, lambda *_: None)


def _in_order(messages):
    """Return one message for each odometry period; until the first command they are repeated."""
    first = [number for number, message in enumerate(messages) if message.header.seq == 0]
    messages = messages[first[-1]:] if first else []
    if not messages or [message.header.seq for message in messages] != [*range(len(messages))]:
        raise DemoError('the recording has gaps')
    return messages


def _check_detector(ticks, moved, parameters):
    """Compare what the detector said with the sum of its steps.

    Nothing tells which odometry a distance belongs to; but from the first one that is not zero on
    both go up together.
    """
    with read_from(parameters):
        counter = read_counter()
    counted = []
    for tick in ticks:
        counter.add(*tick.odometry.position[:2], tick.stamp, tick.stamp)
        counted.append(counter.distance)
    counted, moved = ([distance for distance in distances if distance]
                      for distances in (counted, moved))
    common = min(len(counted), len(moved))
    if counted[:common] != moved[:common]:
        raise DemoError('the detector has counted something else')


def _motion(message):
    pose, twist = message.pose.pose, message.twist.twist
    orientation = pose.orientation
    return Motion(_vector(pose.position),
                  (orientation.x, orientation.y, orientation.z, orientation.w),
                  _vector(twist.linear), _vector(twist.angular))


def _vector(message):
    return message.x, message.y, message.z
