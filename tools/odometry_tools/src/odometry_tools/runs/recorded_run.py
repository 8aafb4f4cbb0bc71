"""Read a run from a bag with odometry."""

import math
import shlex
from pathlib import Path
from typing import NamedTuple

import numpy
import rosbag
from geometry_msgs.msg import Quaternion, Twist
from moved_distance.distance_counter import DistanceCounter
from nav_msgs.msg import Odometry
from odometry_common.angles import wrap_to_pi
from odometry_common.orientation import yaw_from_orientation
from sim_turtlebot.geometry import PlanarPose

from odometry_tools.runs import bags

ODOMETRY_TOPIC = '/odom'
TRUTH = '/base_pose_ground_truth'
COMMANDS = ('cmd_vel', 'mobile_base/commands/velocity', 'cmd_vel_mux/input/teleop',
            'cmd_vel_mux/input/navi')
COMMAND_TOPICS = [f'/{name}' for name in COMMANDS]


class BagError(ValueError):
    """The bag contains no run; the message is one line for the user."""


class Track(NamedTuple):
    """Odometry messages as arrays of the same length."""

    time: numpy.ndarray  # s since the first message of the run
    x: numpy.ndarray  # m
    y: numpy.ndarray  # m
    yaw: numpy.ndarray  # rad, without jumps
    speed: numpy.ndarray  # m/s, forwards; NaN if the driver does not report it
    turn_rate: numpy.ndarray  # rad/s
    distance: numpy.ndarray  # m, as the detector counts it
    jumps: list  # indices of the messages whose step is not counted as movement
    ignored: int  # number of further messages, which are late or not finite

    def moved_onto(self, other):
        """Return the same path, moved so that both start at the same pose."""
        start = max(self.time[0], other.time[0])
        frame = other.at(start).then(self.at(start).inverse())
        x, y, yaw = frame.then(PlanarPose(self.x, self.y, self.yaw))
        return self._replace(x=x, y=y, yaw=yaw)

    def at(self, time):
        """Return the PlanarPose in the message nearest to a time (s)."""
        nearest = numpy.abs(self.time - time).argmin()
        return PlanarPose(self.x[nearest], self.y[nearest], self.yaw[nearest])


class Run(NamedTuple):
    """A run in a bag."""

    name: str  # of the bag, with its folder
    topic: str  # of the odometry
    odometry: Track
    ground_truth: Track  # in the odometry's frame; None if nobody published it
    commands: numpy.ndarray  # rows of time (s), linear (m/s), angular (rad/s)
    differing: list  # topics left out: their messages are defined differently from the installed

    def summary(self):
        """Return distance, duration, speeds, the error, and what was left out, as text."""
        track = self.odometry
        duration = track.time[-1] - track.time[0]
        mean = track.distance[-1] / duration if duration else 0.0
        top = numpy.abs(track.speed).max()
        counts = (len(track.jumps), 'jump', 'not counted'), (track.ignored, 'message', 'ignored')
        left_out = [f'{number} {thing}{"s" * (number > 1)} {how}'
                    for number, thing, how in counts if number]
        left_out += [f'{name}, defined differently from the installed message'
                     for name in self.differing]
        return '\n'.join([f'odometry    {self.topic}',
                          f'distance    {track.distance[-1]:.3f} m',
                          f'duration    {duration:.1f} s',
                          f'mean speed  {mean:.3f} m/s',
                          'top speed   ' + ('unknown: twist.linear.x is always 0'
                                            if math.isnan(top) else f'{top:.3f} m/s'),
                          *(self._error() if self.ground_truth else []),
                          *([f'left out    {", ".join(left_out)}'] if left_out else [])])

    def truth(self, column):
        """Return the ground truth (x, y, yaw or distance) at the time of each odometry message."""
        return numpy.interp(self.odometry.time, self.ground_truth.time,
                            getattr(self.ground_truth, column))

    @property
    def off_truth(self):
        """How far each position of the odometry is from the true one (m)."""
        return numpy.hypot(self.odometry.x - self.truth('x'), self.odometry.y - self.truth('y'))

    @property
    def error(self):
        """The PlanarPose of the odometry, relative to the true one, at the end."""
        end = min(self.odometry.time[-1], self.ground_truth.time[-1])
        return self.ground_truth.at(end).inverse().then(self.odometry.at(end))

    def _error(self):
        yield (f'off truth   {math.hypot(self.error.x, self.error.y):.3f} m, '
               f'{abs(math.degrees(wrap_to_pi(self.error.yaw))):.2f} degrees at the end')


def read_run(path, topic=None, end=math.inf):
    """Return the Run in a bag.

    :param topic: the odometry; None: the only odometry, or /odom
    :param end: of the run (s); later messages are left out
    :raises BagError: if the bag cannot be read, or has no odometry with finite numbers
    """
    try:
        with rosbag.Bag(str(path)) as bag:
            types, differing = bags.types_in(bag), bags.differing_definitions(bag)
            topic = topic or _odometry_topic(types)
            odometry, ground_truth, commands = (
                [row for row in bags.read_messages(bag, kind, *names) if _stamp(row) <= end]
                for kind, names in ((Odometry, [topic]), (Odometry, [TRUTH]),
                                    (Twist, COMMAND_TOPICS)))
    except rosbag.ROSBagUnindexedException:
        raise BagError(f'{path} is not indexed: rosbag reindex {shlex.quote(str(path))}') from None
    except (OSError, rosbag.ROSBagException) as error:
        raise BagError(f'{path} cannot be read: {error}') from None
    except Exception as error:  # noqa: BLE001
        # On damaged bytes rosbag raises KeyError, struct.error and others, some with all the bytes.
        raise BagError(f'{path} is damaged: {error!r:.100}') from None
    if types.get(topic) != Odometry._type:
        raise BagError(f'{path} has {types.get(topic, "no messages")} on {topic}; '
                       f'{_choice(types)}')
    if topic in differing:
        raise BagError(
            f'{path} defines {Odometry._type} on {topic} differently from the installed one')
    if not odometry:
        raise BagError(f'{path} has 0 messages on {topic}')
    start = next(map(_stamp, odometry), 0.0)
    rows = [(_stamp(row) - start, row.message.linear.x, row.message.angular.z)
            for row in commands]
    track, true_track = _track(odometry, start), _track(ground_truth, start)
    if track is None:
        raise BagError(f'{path} has no message with finite numbers on {topic}')
    return Run('/'.join(Path(path).absolute().parts[-2:]), topic, track,
               true_track and true_track.moved_onto(track), numpy.array(rows).reshape(-1, 3),
               sorted(differing.intersection([TRUTH, *COMMAND_TOPICS])))


def _odometry_topic(types):
    """Return the default topic."""
    topics = [name for name, kind in types.items() if kind == Odometry._type]
    return topics[0] if len(topics) == 1 else ODOMETRY_TOPIC


def _choice(types):
    """Return what the user can choose."""
    options = [f'--topic {name}' for name, kind in sorted(types.items()) if kind == Odometry._type]
    return (f'choose its odometry: {" or ".join(options)}' if options
            else f'it has no {Odometry._type}')


def _track(rows, start):
    """Return the Track of the messages with finite numbers; None if there are none."""
    counter, kept, jumps = DistanceCounter(), [], []
    for row in rows:
        pose, twist = row.message.pose.pose, row.message.twist.twist
        speed, turn_rate = twist.linear.x, twist.angular.z
        x, y = pose.position.x, pose.position.y
        try:
            stamp = row.message.header.stamp.to_sec()
            not_counted = counter.add(x, y, stamp, row.timestamp.to_sec())
            yaw = _yaw(pose.orientation)
        except ValueError:  # its position or orientation is not finite
            continue
        is_late = not_counted and kept and _stamp(row) < kept[-1][0]
        if is_late or not math.isfinite(speed):
            continue
        if not_counted:
            jumps.append(len(kept))
        kept.append((_stamp(row), x, y, yaw, speed, turn_rate, counter.distance))
    if not kept:
        return None
    time, x, y, yaw, speed, turn_rate, distance = numpy.array(kept).T
    if distance[-1] and not speed.any():
        speed[:] = math.nan
    return Track(time - start, x, y, numpy.unwrap(yaw), speed, turn_rate, distance, jumps,
                 len(rows) - len(kept))


def _yaw(orientation):
    """Return the yaw (rad); 0 if the driver leaves the orientation empty."""
    return yaw_from_orientation(orientation) if orientation != Quaternion() else 0.0


def _stamp(row):
    """Return the time of a message (s): its stamp, or when it was recorded."""
    measured = row.message.header.stamp.to_sec() if hasattr(row.message, 'header') else 0.0
    return measured or row.timestamp.to_sec()
