"""The picture of a run.

It shows path, distance, error and speed of a drive; heading, error and turn rate of a turn.
"""

import os
import warnings

import numpy

# A Jupyter cell or an editor sets a backend for its own windows, which may not be installed here.
os.environ['MPLBACKEND'] = 'agg'
WIDTH, HEIGHT, PANEL_HEIGHT = 10, 6, 1.6  # inches; a tall picture has many panels
RESOLUTION = 100  # dots per inch
MARGINS = {'left': 0.07, 'right': 0.98, 'bottom': 0.09, 'top': 0.86, 'wspace': 0.2, 'hspace': 0.12}
# Of Okabe and Ito: distinct to the colour-blind, and in grey.
BLUE, ORANGE, GREEN = '#0072b2', '#d55e00', '#009e73'
PALE, DARK = '#b8b8b8', '#303030'
ODOMETRY = {'color': BLUE, 'linewidth': 2, 'label': 'odometry'}
TRUTH = {'color': ORANGE, 'linestyle': (0, (4, 3)), 'linewidth': 1.5, 'label': 'truth'}
COMMANDED = {'color': PALE, 'linewidth': 5, 'label': 'commanded', 'where': 'post'}
TARGET = {'color': DARK, 'linestyle': ':', 'label': 'target'}
MIN_DISTANCE, MIN_TURN = 0.1, 10.0  # m, degrees; less is no drive, or no turn
# By panel: its label, and its minimum span; on a shorter axis noise would look like motion.
PANELS = {
    'distance': ('distance (m)', 0.1),
    'off truth': ('off truth (m)', 0.02),
    'speed': ('speed (m/s)', 0.05),
    'heading': ('heading (degrees)', 2.0),
    'error': ('error (degrees)', 2.0),
    'turn rate': ('turn rate (rad/s)', 0.05)}
PATH_SPAN = 0.6  # m
MISSING_GLYPHS = 'Glyph .* missing from', 'Matplotlib currently does not support'  # in the font
LONGEST_NAME = 55  # characters, beside the legend


def new_figure(width, height, **options):
    """Return an empty matplotlib Figure of this size (inches), for a file."""
    from matplotlib import rcParams  # takes long to import
    from matplotlib.figure import Figure
    rcParams['text.parse_math'] = False  # a name with two dollar signs is no formula
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
    turns = has_turned or heading_target is not None
    panels = _panels(drives, turns, bool(run.ground_truth), heading_target is not None)
    targets = _targets(run, distance_target, heading_target)
    figure = new_figure(WIDTH, max(HEIGHT, PANEL_HEIGHT * len(panels)))
    grid = figure.add_gridspec(len(panels), 1 + drives, **MARGINS)
    if drives:
        _draw_path(figure.add_subplot(grid[:, 0]), run)
    for row, panel in enumerate(panels):
        _draw_panel(figure.add_subplot(grid[row, -1]), panel, run, targets)
    tidy(*figure.axes)
    for axes in figure.axes[drives:-1]:
        axes.tick_params(labelbottom=False)
    figure.axes[-1].set_xlabel('time (s)')
    figure.align_ylabels(figure.axes[drives:])
    _write_title(figure, run, distance_target, heading_target)
    _add_legend(figure)
    return figure


def _panels(drives, turns, has_truth, has_target):
    """Return the names of the panels, from top to bottom."""
    shown = {
        'distance': drives,
        'off truth': drives and has_truth,
        'speed': drives,
        'heading': turns,
        'error': turns and has_target,
        'turn rate': turns}
    return [panel for panel, is_shown in shown.items() if is_shown]


def _targets(run, distance, heading):
    """Return the target of each panel that has one."""
    targets = {'distance': distance}
    if heading is not None:
        # A turn to 270 degrees may end at -90.
        turns = round((numpy.degrees(run.odometry.yaw[-1]) - heading) / 360)
        targets['heading'] = heading + 360 * turns
        targets['error'] = 0.0
    return targets


def _add_legend(figure):
    """Name each kind of line once, above all panels."""
    handles = {}
    for axes in figure.axes:
        for handle, label in zip(*axes.get_legend_handles_labels()):
            handles[label] = handle
    figure.legend(handles.values(), handles, loc='upper right', ncols=len(handles), frameon=False,
                  bbox_to_anchor=(0.99, 0.93))


def tidy(*all_axes):
    """Leave only what helps to read values."""
    for axes in all_axes:
        axes.spines[['top', 'right']].set_visible(False)
        axes.grid(True, color='#e4e4e4')
        axes.set_axisbelow(True)


def _write_title(figure, run, distance_target, heading_target):
    """Write the result in words, and below it, small, where it comes from."""
    if heading_target is None:
        figures = [f'{distance:.3f} m' for distance in _growth(run, 'distance')]
        target = distance_target and f'{distance_target:g} m'
    else:
        figures = [f'{turned:.1f} degrees' for turned in numpy.degrees(_growth(run, 'yaw'))]
        figures[0], target = f'turned {figures[0]}', f'{heading_target:g} degrees'
    result = f'{figures[0]} by odometry, {figures[1]} true,' if run.ground_truth else figures[0]
    time = run.odometry.time
    title = f'{result} in {time[-1] - time[0]:.1f} s' + (f', target {target}' if target else '')
    figure.suptitle(title, x=0.07, ha='left', fontsize=14, color=DARK)
    name = run.name if len(run.name) <= LONGEST_NAME else f'...{run.name[3 - LONGEST_NAME:]}'
    figure.text(0.07, 0.9, name, fontsize=8, color='grey')


def _growth(run, column):
    """Return by how much a column of the odometry and, if it is known, of the truth has grown."""
    columns = [getattr(run.odometry, column), *([run.truth(column)] if run.ground_truth else [])]
    return [values[-1] - values[0] for values in columns]


def _draw_path(axes, run):
    track = run.odometry
    for points, style in _tracks(run):
        # Leave a gap at jumps; the path between is unknown.
        axes.plot(*(numpy.insert(values, points.jumps, numpy.nan)
                    for values in (points.x, points.y)), **style)
    axes.plot(track.x[0], track.y[0], 'o', color=GREEN, markersize=9, label='start')
    axes.plot(track.x[-1], track.y[-1], 's', color=DARK, markersize=7, label='end')
    _show_at_least(PATH_SPAN, axes)
    axes.set_aspect('equal', adjustable='datalim')
    axes.set(xlabel='x (m)', ylabel='y (m)')


def _draw_panel(axes, panel, run, targets):
    label, span = PANELS[panel]
    axes.set_ylabel(label)
    if panel == 'off truth':
        axes.plot(run.odometry.time, run.off_truth, color=BLUE, linewidth=2)
        _show_at_least(span, axes)
        return
    if panel in ('speed', 'turn rate') and len(run.commands):
        time, linear, angular = run.commands.T
        axes.step(time, linear if panel == 'speed' else angular, **COMMANDED)
    for track, style in _tracks(run):
        values = {
            'distance': track.distance,
            'speed': track.speed,
            'turn rate': track.turn_rate,
            'heading': numpy.degrees(track.yaw),
            'error': numpy.degrees(track.yaw) - targets.get('heading', 0.0)}
        axes.plot(track.time, values[panel], **style)
    if targets.get(panel) is not None:
        axes.axhline(targets[panel], **TARGET)
    _show_at_least(span, axes)


def _tracks(run):
    """Return the Tracks to draw, each with its style."""
    return [(run.odometry, ODOMETRY), *([(run.ground_truth, TRUTH)] if run.ground_truth else [])]


def _show_at_least(span, axes):
    """Show a span of values, or more, about the middle of what is drawn."""
    middle = sum(axes.get_ylim()) / 2
    # Fixed limits would be in the way of the equal scales of the path.
    axes.update_datalim([(0, middle - span / 2), (0, middle + span / 2)], updatex=False)
    axes.autoscale_view()
