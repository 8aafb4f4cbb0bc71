"""A picture of a run, from a bag with odometry in it."""

import math
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple

import numpy
import rosbag
from geometry_msgs.msg import Quaternion
from moved_distance.distance_counter import DistanceCounter
from odometry_common.geometry import PlanarPose, yaw_from_orientation

from odometry_launch.drawing import new_figure

TWO_METRES = 2.0  # where the tutorial's robot stops
SMALLEST_SPAN = 2.0  # degrees of heading; less would make noise look like a turn
FIGURE_SIZE = (11, 8)  # inches
ODOMETRY, COMMAND = 'nav_msgs/Odometry', 'geometry_msgs/Twist'


class BagError(ValueError):
    """A bag that no picture can be made of; the message is one line for the user."""


class Track(NamedTuple):
    """Odometry messages as arrays of the same length."""

    time: numpy.ndarray  # s since the first message of the run
    x: numpy.ndarray  # m
    y: numpy.ndarray  # m
    yaw: numpy.ndarray  # rad, without jumps
    speed: numpy.ndarray  # m/s, forwards
    distance: numpy.ndarray  # m, as the detector counts it

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
    odometry: Track
    ground_truth: Track  # in the odometry's frame; None if nobody published it
    commands: numpy.ndarray  # rows of time (s), linear (m/s), angular (rad/s)

    def summary(self):
        """Return distance, duration and speeds in words."""
        track = self.odometry
        duration = track.time[-1] - track.time[0]
        mean = track.distance[-1] / duration if duration else 0.0
        return (f'distance    {track.distance[-1]:.3f} m\n'
                f'duration    {duration:.1f} s\n'
                f'mean speed  {mean:.3f} m/s\n'
                f'top speed   {numpy.abs(track.speed).max():.3f} m/s')


def read_run(path, odometry_topic='/odom', end=math.inf):
    """Return the Run in a bag.

    :param end: of the run (s); what is later is left out
    :raises BagError: if it is not a bag, has messages of another type on one of the topics, or no
        odometry with finite numbers
    """
    try:
        with rosbag.Bag(str(path)) as bag:
            odometry, ground_truth, commands = (
                _messages(bag, topic, kind, end) for topic, kind in (
                    (odometry_topic, ODOMETRY), ('/base_pose_ground_truth', ODOMETRY),
                    ('/cmd_vel', COMMAND)))
    except (OSError, rosbag.ROSBagException) as error:
        raise BagError(f'{path} cannot be read: {error}') from None
    if not odometry:
        raise BagError(f'{path} has no messages on {odometry_topic}')
    start = _stamp(odometry[0])
    rows = [(_stamp(row) - start, row.message.linear.x, row.message.angular.z)
            for row in commands]
    track, true_track = _track(odometry, start), _track(ground_truth, start)
    if track is None:
        raise BagError(f'{path} has no finite position on {odometry_topic}')
    return Run('/'.join(Path(path).absolute().parts[-2:]), track,
               true_track and true_track.moved_onto(track), numpy.array(rows).reshape(-1, 3))


def _messages(bag, topic, kind, end):
    """Return the messages of a topic up to a time (s); their type has to be `kind`."""
    found = bag.get_type_and_topic_info(topic).topics.get(topic)
    if found and found.msg_type != kind:
        raise BagError(f'{bag.filename} has {found.msg_type} on {topic}, but must have {kind}')
    return [row for row in bag.read_messages(topic) if _stamp(row) <= end]


def make_figure(run):
    """Return a figure of path, distance, speed and heading of a Run."""
    figure = new_figure(*FIGURE_SIZE)
    figure.suptitle(run.name)
    path, distance, speed, heading = figure.subplots(2, 2).flat
    if len(run.commands):
        time, linear, _ = run.commands.T
        speed.step(time, linear, where='post', color='grey', label='commanded')
    _draw_track(figure.axes, run.odometry, '-', 'odometry')
    if run.ground_truth is not None:
        _draw_track(figure.axes, run.ground_truth, '--', 'truth')
    path.plot(run.odometry.x[0], run.odometry.y[0], 'o', label='start')
    path.plot(run.odometry.x[-1], run.odometry.y[-1], 's', label='end')
    path.set_aspect('equal', adjustable='datalim')
    if TWO_METRES / 2 <= run.odometry.distance[-1] <= TWO_METRES * 2:
        distance.axhline(TWO_METRES, color='grey', linestyle=':', label='two metres')
    middle, span = numpy.mean(heading.get_ylim()), numpy.ptp(heading.get_ylim())
    heading.set_ylim(middle - max(span, SMALLEST_SPAN) / 2, middle + max(span, SMALLEST_SPAN) / 2)
    path.set(title='path from above', xlabel='x (m)', ylabel='y (m)')
    distance.set(title='moved distance', xlabel='time (s)', ylabel='distance (m)')
    speed.set(title='speed', xlabel='time (s)', ylabel='speed (m/s)')
    heading.set(title='heading', xlabel='time (s)', ylabel='heading (degrees)')
    for axes in figure.axes:
        axes.legend()
        axes.grid(True)
    return figure


def _draw_track(all_axes, track, style, label):
    path, distance, speed, heading = all_axes
    path.plot(track.x, track.y, style, label=label)
    distance.plot(track.time, track.distance, style, label=label)
    speed.plot(track.time, track.speed, style, label=label)
    heading.plot(track.time, numpy.degrees(track.yaw), style, label=label)


def _track(rows, start):
    """Return the Track of the messages whose numbers are finite; None if there are none."""
    counter, kept = DistanceCounter(), []
    for row in rows:
        pose, speed = row.message.pose.pose, row.message.twist.twist.linear.x
        x, y = pose.position.x, pose.position.y
        with suppress(ValueError):  # of a position or an orientation that is not finite
            counter.add(x, y, row.message.header.stamp.to_sec(), row.timestamp.to_sec())
            yaw = _yaw(pose.orientation)
            if math.isfinite(speed):
                kept.append((_stamp(row), x, y, yaw, speed, counter.distance))
    if not kept:
        return None
    time, x, y, yaw, *others = numpy.array(kept).T
    return Track(time - start, x, y, numpy.unwrap(yaw), *others)


def _yaw(orientation):
    """Return the yaw (rad); 0 if the driver leaves the orientation empty."""
    return 0.0 if orientation == Quaternion() else yaw_from_orientation(orientation)


def _stamp(row):
    """Return when a message was measured, or recorded if it does not say (s)."""
    measured = row.message.header.stamp.to_sec() if hasattr(row.message, 'header') else 0.0
    return measured or row.timestamp.to_sec()
