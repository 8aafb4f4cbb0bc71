"""What the figures of a campaign must not exceed."""

from odometry_common.parameters import StartError

from odometry_sweep.figures import FIGURES
from odometry_sweep.summary import STATISTICS

NOT_ARRIVED = 'not_arrived'


def check_limits(tutorial, limits):
    """Raise StartError, with one line for the user, if limits by their names make no sense."""
    figures = FIGURES[tutorial]
    known = [NOT_ARRIVED, *(f'{figure}_{statistic}' for figure in figures
                            for statistic in STATISTICS)]
    for name, limit in limits.items():
        if name not in known:
            raise StartError(f'unknown limit {name}; it is {NOT_ARRIVED}, or one of '
                             f'{", ".join(figures)} with one of '
                             f'{", ".join(f"_{statistic}" for statistic in STATISTICS)} behind it')
        is_number = isinstance(limit, (int, float)) and not isinstance(limit, bool)
        if not is_number or not limit >= 0:
            raise StartError(f'limit {name} is {limit!r}, but must be a number from 0')


def broken(limits, setting):
    """Yield a line for each limit, by its name, that a Setting breaks."""
    for limit, most in limits.items():
        if limit == NOT_ARRIVED:
            value = setting.not_arrived
        else:
            figure, _, statistic = limit.rpartition('_')
            value = setting.size(figure, statistic)
        if not value <= most:
            yield f'{limit} is {value:.6g}, over its limit of {most:g}, with {setting.name}'
