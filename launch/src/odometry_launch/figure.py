"""The picture of a run: path, distance, speed and heading."""

import os

import numpy

# Jupyter and editors set a backend of their own, which may not be installed here.
os.environ['MPLBACKEND'] = 'agg'
# Of path and distance (m), speed (m/s) and heading (degrees); on smaller axes noise looks like motion.
MIN_SPANS = 0.5, 0.1, 0.05, 2.0
FIGURE_SIZE = (11, 8)  # inches
RESOLUTION = 100  # dots per inch


def new_figure(width, height):
    """Return an empty matplotlib Figure of this size (inches), for a file."""
    from matplotlib.figure import Figure  # takes long to import
    return Figure((width, height), dpi=RESOLUTION, layout='constrained')


def make_figure(run, distance_target=None, heading_target=None):
    """Return a figure of path, distance, speed and heading of a Run.

    :param distance_target: m; None: unknown
    :param heading_target: degrees; None: unknown
    """
    figure = new_figure(*FIGURE_SIZE)
    figure.suptitle(run.name)
    path, distance, speed, heading = figure.subplots(2, 2).flat
    if len(run.commands):
        time, linear, _ = run.commands.T
        speed.step(time, linear, where='post', color='lightgrey', linewidth=5, label='commanded')
    _draw_track(figure.axes, run.odometry, '-', 'odometry')
    if run.ground_truth is not None:
        _draw_track(figure.axes, run.ground_truth, '--', 'truth')
    path.plot(run.odometry.x[0], run.odometry.y[0], 'o', label='start')
    path.plot(run.odometry.x[-1], run.odometry.y[-1], 's', label='end')
    if distance_target is not None:
        _draw_target(distance, distance_target)
    if heading_target is not None:
        turns = round((numpy.degrees(run.odometry.yaw[-1]) - heading_target) / 360)
        _draw_target(heading, heading_target + 360 * turns)
    for axes, span in zip(figure.axes, MIN_SPANS):
        _show_at_least(span, axes)
    path.set_aspect('equal', adjustable='datalim')
    path.set(title='path from above', xlabel='x (m)', ylabel='y (m)')
    distance.set(title='moved distance', xlabel='time (s)', ylabel='distance (m)')
    speed.set(title='speed', xlabel='time (s)', ylabel='speed (m/s)')
    heading.set(title='heading', xlabel='time (s)', ylabel='heading (degrees)')
    for axes in figure.axes:
        axes.legend()
        axes.grid(True)
    return figure


def _draw_target(axes, value):
    axes.axhline(value, color='grey', linestyle=':', label=f'target, {value:g}')


def _show_at_least(span, axes):
    """Extend the y axis to at least `span`, about its middle."""
    middle = sum(axes.get_ylim()) / 2
    # Not by fixed limits: the path needs equal scales.
    axes.update_datalim([(0, middle - span / 2), (0, middle + span / 2)], updatex=False)
    axes.autoscale_view()


def _draw_track(all_axes, track, style, label):
    path, distance, speed, heading = all_axes
    # Leave a gap at jumps; the path between is unknown.
    path.plot(*(numpy.insert(values, track.jumps, numpy.nan) for values in (track.x, track.y)), style,
              label=label)
    distance.plot(track.time, track.distance, style, label=label)
    speed.plot(track.time, track.speed, style, label=label)
    heading.plot(track.time, numpy.degrees(track.yaw), style, label=label)
