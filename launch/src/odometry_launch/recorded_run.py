"""A recorded run, from a bag with odometry in it."""

import math
from pathlib import Path
from typing import NamedTuple

import numpy
import rosbag
from geometry_msgs.msg import Quaternion
from moved_distance.distance_counter import DistanceCounter
from odometry_common.geometry import PlanarPose, yaw_from_orientation

ODOMETRY, COMMAND = 'nav_msgs/Odometry', 'geometry_msgs/Twist'
ODOMETRY_TOPIC = '/odom'


class BagError(ValueError):
    """A bag without a run; the message is one line for the user."""


class Track(NamedTuple):
    """Odometry messages as arrays of the same length."""

    time: numpy.ndarray  # s since the first message of the run
    x: numpy.ndarray  # m
    y: numpy.ndarray  # m
    yaw: numpy.ndarray  # rad, without jumps
    speed: numpy.ndarray  # m/s, forwards
    distance: numpy.ndarray  # m, as the detector counts it
    jumps: list  # indices of the messages whose step is not counted, since it is no movement
    ignored: int  # number of further messages, which are late or not finite

    def moved_onto(self, other):
        """Return the same path, rotated and shifted so that it begins where another one does."""
        frame = other.start.then(self.start.inverse())
        x, y, yaw = frame.then(PlanarPose(self.x, self.y, self.yaw))
        return self._replace(x=x, y=y, yaw=yaw)

    @property
    def start(self):
        """The PlanarPose where it begins."""
        return PlanarPose(self.x[0], self.y[0], self.yaw[0])


class Run(NamedTuple):
    """What a bag says about a run."""

    name: str  # of the bag, with its folder
    topic: str  # of the odometry
    odometry: Track
    ground_truth: Track  # in the odometry's frame; None if nobody published it
    commands: numpy.ndarray  # rows of time (s), linear (m/s), angular (rad/s)

    def summary(self):
        """Return distance, duration and speeds in words, and what was left out."""
        track = self.odometry
        duration = track.time[-1] - track.time[0]
        mean = track.distance[-1] / duration if duration else 0.0
        left_out = [f'{_in_words(number, thing)} {how}' for number, thing, how in (
            (len(track.jumps), 'jump', 'not counted'), (track.ignored, 'message', 'ignored')) if number]
        return '\n'.join([f'odometry    {self.topic}',
                          f'distance    {track.distance[-1]:.3f} m',
                          f'duration    {duration:.1f} s',
                          f'mean speed  {mean:.3f} m/s',
                          f'top speed   {numpy.abs(track.speed).max():.3f} m/s',
                          *([f'left out    {", ".join(left_out)}'] if left_out else [])])


def read_run(path, topic=None, end=math.inf):
    """Return the Run in a bag.

    :param topic: the odometry; None: /odom or, in a bag without that, the only odometry
    :param end: of the run (s); what is later is left out
    :raises BagError: if it is not a bag, has messages of another type on one of the topics, or no
        odometry with finite numbers
    """
    try:
        with rosbag.Bag(str(path)) as bag:
            topic = topic or _odometry_topic(bag)
            odometry, ground_truth, commands = (
                _messages(bag, name, kind, end) for name, kind in (
                    (topic, ODOMETRY), ('/base_pose_ground_truth', ODOMETRY), ('/cmd_vel', COMMAND)))
            others = ', '.join(_odometry_topics(bag))
    except (OSError, rosbag.ROSBagException) as error:
        raise BagError(f'{path} cannot be read: {error}') from None
    if not odometry:
        raise BagError(f'{path} has no messages on {topic}; '
                       f'topics of type {ODOMETRY}: {others or "none"}')
    start = _stamp(odometry[0])
    rows = [(_stamp(row) - start, row.message.linear.x, row.message.angular.z)
            for row in commands]
    track, true_track = _track(odometry, start), _track(ground_truth, start)
    if track is None:
        raise BagError(f'{path} has no finite position on {topic}')
    return Run('/'.join(Path(path).absolute().parts[-2:]), topic, track,
               true_track and true_track.moved_onto(track), numpy.array(rows).reshape(-1, 3))


def _odometry_topics(bag):
    return sorted(name for name, topic in bag.get_type_and_topic_info().topics.items()
                  if topic.msg_type == ODOMETRY)


def _odometry_topic(bag):
    """Return the topic that a user who names none means."""
    topics = _odometry_topics(bag)
    return topics[0] if len(topics) == 1 else ODOMETRY_TOPIC


def _messages(bag, topic, kind, end):
    """Return the messages of a topic up to a time (s); their type has to be `kind`."""
    found = bag.get_type_and_topic_info(topic).topics.get(topic)
    if found and found.msg_type != kind:
        raise BagError(f'{bag.filename} has {found.msg_type} on {topic}, but must have {kind}')
    return [row for row in bag.read_messages(topic) if _stamp(row) <= end]


def _track(rows, start):
    """Return the Track of the messages whose numbers are finite; None if there are none."""
    counter, kept, jumps = DistanceCounter(), [], []
    for row in rows:
        pose, speed = row.message.pose.pose, row.message.twist.twist.linear.x
        x, y = pose.position.x, pose.position.y
        try:
            not_counted = counter.add(x, y, row.message.header.stamp.to_sec(), row.timestamp.to_sec())
            yaw = _yaw(pose.orientation)
        except ValueError:  # a position or an orientation that is not finite
            continue
        is_late = not_counted and kept and _stamp(row) < kept[-1][0]
        if is_late or not math.isfinite(speed):
            continue
        if not_counted:
            jumps.append(len(kept))
        kept.append((_stamp(row), x, y, yaw, speed, counter.distance))
    if not kept:
        return None
    time, x, y, yaw, *others = numpy.array(kept).T
    return Track(time - start, x, y, numpy.unwrap(yaw), *others, jumps, len(rows) - len(kept))


def _in_words(number, thing):
    return f'{number} {thing}' if number == 1 else f'{number} {thing}s'


def _yaw(orientation):
    """Return the yaw (rad); 0 if the driver leaves the orientation empty."""
    return 0.0 if orientation == Quaternion() else yaw_from_orientation(orientation)


def _stamp(row):
    """Return when a message was measured, or recorded if it does not say (s)."""
    measured = row.message.header.stamp.to_sec() if hasattr(row.message, 'header') else 0.0
    return measured or row.timestamp.to_sec()
