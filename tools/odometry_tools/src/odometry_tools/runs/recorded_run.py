"""Read a run from a bag with odometry."""

import math
import operator
import shlex
from pathlib import Path
from typing import NamedTuple

import numpy
import rosbag
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from odometry_common.angles import wrap_to_pi

from odometry_tools.runs import bags
from odometry_tools.runs.track import Track, last_restart, timed, track_of

ODOMETRY_TOPIC = '/odom'
TRUTH = '/base_pose_ground_truth'
COMMANDS = ('cmd_vel', 'mobile_base/commands/velocity', 'cmd_vel_mux/input/teleop',
            'cmd_vel_mux/input/navi')
COMMAND_TOPICS = [f'/{name}' for name in COMMANDS]


class BagError(ValueError):
    """The bag contains no run; the message is one line for the user."""


class Run(NamedTuple):
    """A run in a bag."""

    name: str  # of the bag, with its folder
    topic: str  # of the odometry
    odometry: Track
    ground_truth: Track  # in the odometry's frame; None if nobody published it then
    commands: numpy.ndarray  # rows of time (s), linear (m/s), angular (rad/s)
    differing: list  # topics left out: their messages are defined differently from the installed

    @property
    def tracks(self):
        """The odometry and, if it is known, the ground truth."""
        return [track for track in (self.odometry, self.ground_truth) if track]

    def summary(self):
        """Return distance, duration, the error, and what was left out, as text."""
        track = self.odometry
        lines = [f'odometry    {self.topic}',
                 f'distance    {track.distance[-1]:.3f} m',
                 f'duration    {track.time[-1] - track.time[0]:.1f} s']
        if self.ground_truth:
            x, y, yaw = self.error
            lines.append(f'off truth   {math.hypot(x, y):.3f} m, '
                         f'{abs(math.degrees(wrap_to_pi(yaw))):.2f} degrees at the end')
        counts = (len(track.jumps), 'jump', 'not counted'), (track.ignored, 'message', 'ignored')
        left_out = [f'{number} {thing}{"s" * (number > 1)} {how}'
                    for number, thing, how in counts if number]
        left_out += [f'{name}, defined differently from the installed message'
                     for name in self.differing]
        if left_out:
            lines.append(f'left out    {", ".join(left_out)}')
        return '\n'.join(lines)

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


def read_run(path, topic=None, end=math.inf):
    """Return the Run in a bag.

    :param topic: the odometry; None: the only odometry, or /odom
    :param end: of the run (s); later messages are left out
    :raises BagError: if the bag cannot be read, or has no odometry with finite numbers
    """
    try:
        with rosbag.Bag(str(path)) as bag:
            types, differing = bags.types_in(bag), bags.differing_definitions(bag)
            choices = [name for name, kind in sorted(types.items()) if kind == Odometry._type]
            topic = topic or (choices[0] if len(choices) == 1 else ODOMETRY_TOPIC)
            odometry, ground_truth, *commands = (
                timed(bags.read_messages(bag, kind, name), end)
                for kind, name in (
                    (Odometry, topic), (Odometry, TRUTH),
                    *((Twist, command_topic) for command_topic in COMMAND_TOPICS)))
    except rosbag.ROSBagUnindexedException:
        raise BagError(f'{path} is not indexed: rosbag reindex {shlex.quote(str(path))}') from None
    except (OSError, rosbag.ROSBagException) as error:
        raise BagError(f'{path} cannot be read: {error}') from None
    except Exception as error:  # noqa: BLE001
        # On damaged bytes rosbag raises KeyError, struct.error and others, some with all the bytes.
        raise BagError(f'{path} is damaged: {error!r:.100}') from None
    if topic not in choices:
        options = ' or '.join(f'--topic {name}' for name in choices)
        hint = f'choose its odometry: {options}' if options else f'it has no {Odometry._type}'
        raise BagError(f'{path} has {types.get(topic, "no messages")} on {topic}; {hint}')
    if topic in differing:
        raise BagError(
            f'{path} defines {Odometry._type} on {topic} differently from the installed one')
    if not odometry:
        raise BagError(f'{path} has 0 messages on {topic}')
    start, first = odometry[last_restart(odometry)]
    # Commands have no stamp, and the clock that recorded them may be another.
    rows = [
        ((row.timestamp - first.timestamp).to_sec(), row.message.linear.x, row.message.angular.z)
        for messages in commands for _, row in messages[last_restart(messages):]
        if row.timestamp >= first.timestamp]
    rows.sort(key=operator.itemgetter(0))
    track, true_track = track_of(odometry, start), track_of(ground_truth, start)
    if track is None:
        raise BagError(f'{path} has no message with finite numbers on {topic}')
    return Run('/'.join(Path(path).absolute().parts[-2:]), topic, track,
               true_track and true_track.moved_onto(track), numpy.array(rows).reshape(-1, 3),
               sorted(differing.intersection([TRUTH, *COMMAND_TOPICS])))
