"""The picture of a run: path, distance, speed and heading."""

import numpy

from run_plot.drawing import new_figure

TWO_METRES = 2.0  # where the tutorial's robot stops
SMALLEST_SPAN = 2.0  # degrees of heading; less would make noise look like a turn
FIGURE_SIZE = (11, 8)  # inches


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
    # Nobody knows the way of a jump: the line has a gap there.
    path.plot(*(numpy.insert(values, track.jumps, numpy.nan) for values in (track.x, track.y)), style,
              label=label)
    distance.plot(track.time, track.distance, style, label=label)
    speed.plot(track.time, track.speed, style, label=label)
    heading.plot(track.time, numpy.degrees(track.yaw), style, label=label)
