"""The picture of a run.

It shows path, distance, error and speed of a drive; heading and turn rate of a turn.
"""

import os
import warnings
from typing import NamedTuple

import numpy

# A Jupyter cell or an editor sets a backend for its own windows, which may not be installed here.
os.environ['MPLBACKEND'] = 'agg'
WIDTH, HEIGHT, PANEL_HEIGHT = 10, 6, 1.6  # inches; a tall picture has many panels
RESOLUTION = 100  # dots per inch
LOOK = {
    'axes.spines.top': False,
    'axes.spines.right': False,
    'axes.grid': True,
    'grid.color': '#e4e4e4',
    'text.parse_math': False}  # a name with two dollar signs is no formula
# Of Okabe and Ito: distinct to the colour-blind, and in grey.
BLUE, ORANGE, GREEN = '#0072b2', '#d55e00', '#009e73'
PALE, DARK = '#b8b8b8', '#303030'
STYLES = ({'color': BLUE, 'linewidth': 2, 'label': 'odometry'},
          {'color': ORANGE, 'linestyle': (0, (4, 3)), 'linewidth': 1.5, 'label': 'truth'})
COMMANDED = {'color': PALE, 'linewidth': 5, 'label': 'commanded', 'where': 'post'}
TARGET = {'color': DARK, 'linestyle': ':', 'label': 'target'}
MIN_DISTANCE, MIN_TURN = 0.1, 10.0  # m, degrees; less is no drive, or no turn
PATH_SPAN = 0.6  # m
MISSING_GLYPHS = 'Glyph .* missing from', 'Matplotlib currently does not support'  # in the font


class Panel(NamedTuple):
    """A diagram over time."""

    label: str
    span: float  # shown at least; on a shorter axis noise would look like motion
    series: list  # values by odometry and, if known, the true ones
    commanded: int = None  # column of the run's commands
    target: float = None


def new_figure(width, height, **options):
    """Return an empty matplotlib Figure of this size (inches), for a file."""
    from matplotlib import rcParams  # takes long to import
    from matplotlib.figure import Figure
    rcParams.update(LOOK)
    for message in MISSING_GLYPHS:
        warnings.filterwarnings('ignore', message)
    return Figure((width, height), dpi=RESOLUTION, **options)


def make_figure(run, distance_target=None, heading_target=None):
    """Return a figure of a Run, with panels for what the robot did.

    :param distance_target: m; None: not known
    :param heading_target: degrees; None: not known
    """
    has_turned = numpy.degrees(numpy.ptp(run.odometry.yaw)) >= MIN_TURN
    drives = bool(run.odometry.distance[-1] >= MIN_DISTANCE or not has_turned)
    panels = _drive_panels(run, distance_target) if drives else []
    if has_turned or heading_target is not None:
        panels += _turn_panels(run, heading_target)
    figure = new_figure(WIDTH, max(HEIGHT, PANEL_HEIGHT * len(panels)), layout='constrained')
    grid = figure.add_gridspec(len(panels), 1 + drives)
    if drives:
        _draw_path(figure.add_subplot(grid[:, 0]), run)
    for row, panel in enumerate(panels):
        _draw_panel(figure.add_subplot(grid[row, -1]), run, panel)
    for axes in figure.axes[drives:-1]:
        axes.tick_params(labelbottom=False)
    figure.axes[-1].set_xlabel('time (s)')
    figure.align_ylabels(figure.axes[drives:])
    _write_title(figure, run, distance_target, heading_target)
    legend = {}  # each kind of line once
    for axes in figure.axes:
        lines, labels = axes.get_legend_handles_labels()
        legend.update(zip(labels, lines))
    figure.legend(legend.values(), legend, loc='outside lower center', ncols=len(legend),
                  frameon=False)
    return figure


def _drive_panels(run, target):
    """Return the Panels of a drive, from top to bottom."""
    distances = [track.distance for track in run.tracks]
    speeds = [track.speed for track in run.tracks]
    panels = [Panel('distance (m)', 0.1, distances, target=target)]
    if run.ground_truth:
        panels.append(Panel('off truth (m)', 0.02, [run.off_truth]))
    return [*panels, Panel('speed (m/s)', 0.05, speeds, commanded=1)]


def _turn_panels(run, target):
    """Return the Panels of a turn, from top to bottom."""
    headings = [numpy.degrees(track.yaw) for track in run.tracks]
    turn_rates = [track.turn_rate for track in run.tracks]
    if target is not None:
        # A turn to 270 degrees may end at -90.
        target += 360 * round((headings[0][-1] - target) / 360)
    return [Panel('heading (degrees)', 2.0, headings, target=target),
            Panel('turn rate (rad/s)', 0.05, turn_rates, commanded=2)]


def _write_title(figure, run, distance_target, heading_target):
    """Write the result in words, and below it the name of the bag."""
    if heading_target is None:
        target, unit, column, factor, form = distance_target, 'm', 'distance', 1.0, '.3f'
    else:
        target, unit, column, factor, form = heading_target, 'degrees', 'yaw', 180 / numpy.pi, '.1f'
    columns = [getattr(run.odometry, column)]
    if run.ground_truth:
        columns.append(run.truth(column))
    figures = [f'{factor * (values[-1] - values[0]):{form}} {unit}' for values in columns]
    if heading_target is not None:
        figures[0] = f'turned {figures[0]}'
    result = f'{figures[0]} by odometry, {figures[1]} true,' if run.ground_truth else figures[0]
    time = run.odometry.time
    title = f'{result} in {time[-1] - time[0]:.1f} s'
    if target is not None:
        title += f', target {target:g} {unit}'
    figure.suptitle(f'{title}\n{run.name}', x=0.01, ha='left', color=DARK)


def _draw_path(axes, run):
    track = run.odometry
    for points, style in zip(run.tracks, STYLES):
        # Leave a gap at jumps; the path between is unknown.
        x, y = (numpy.insert(values, points.jumps, numpy.nan) for values in (points.x, points.y))
        axes.plot(x, y, **style)
    axes.plot(track.x[0], track.y[0], 'o', color=GREEN, markersize=9, label='start')
    axes.plot(track.x[-1], track.y[-1], 's', color=DARK, markersize=7, label='end')
    _show_at_least(PATH_SPAN, axes)
    axes.set_aspect('equal', adjustable='datalim')
    axes.set(xlabel='x (m)', ylabel='y (m)')


def _draw_panel(axes, run, panel):
    axes.set_ylabel(panel.label)
    if panel.commanded and len(run.commands):
        commands = run.commands.T
        axes.step(commands[0], commands[panel.commanded], **COMMANDED)
    for track, values, style in zip(run.tracks, panel.series, STYLES):
        axes.plot(track.time, values, **style)
    if panel.target is not None:
        axes.axhline(panel.target, **TARGET)
    _show_at_least(panel.span, axes)


def _show_at_least(span, axes):
    """Show a span of values, or more, about the middle of what is drawn."""
    middle = sum(axes.get_ylim()) / 2
    # Fixed limits would be in the way of the equal scales of the path.
    axes.update_datalim([(0, middle - span / 2), (0, middle + span / 2)], updatex=False)
    axes.autoscale_view()
