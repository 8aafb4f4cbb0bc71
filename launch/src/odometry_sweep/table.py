"""The figures of a sweep, on the terminal."""

from odometry_sweep.figures import FIGURES, JUDGED
from odometry_sweep.summary import STATISTICS

HEADINGS = {'median': 'median', 'p5': '5 %', 'p95': '95 %', 'worst': 'worst'}
DECIMALS = {'m': 4, 'degrees': 3, 's': 2}
COLUMN = 10  # characters


def table(tutorial, settings):
    """Return a block for each figure, with a line for each Setting."""
    units = FIGURES[tutorial]
    titles = {figure: f'{figure} ({units[figure]})' for figure in JUDGED[tutorial]}
    width = max(map(len, [*titles.values(), *(setting.name for setting in settings)]))
    return '\n\n'.join(_block(figure, title.ljust(width), DECIMALS[units[figure]], settings)
                       for figure, title in titles.items())


def name_of(varied, parameters):
    """Return what tells a setting from the others, by the parameters that vary."""
    return ', '.join(f'{name} {parameters[name]}' for name in varied) or 'all runs'


def _block(figure, title, decimals, settings):
    lines = [title + ''.join(HEADINGS[name].rjust(COLUMN) for name in STATISTICS)]
    for setting in settings:
        numbers = (setting.statistic(figure, name) for name in STATISTICS)
        lines.append(setting.name.ljust(len(title)) + ''.join(
            _rounded(number, decimals).rjust(COLUMN) for number in numbers))
    return '\n'.join(lines)


def _rounded(number, decimals):
    """Return the number as a text, zero without a sign."""
    return f'{round(number, decimals) + 0.0:.{decimals}f}'
