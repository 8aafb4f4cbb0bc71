"""The live plots: distance and heading over time."""

import numpy

HEIGHT = 150  # pixels
PADDING = (10, 20, 0, 0)  # pixels: top, right, bottom, left
MARGIN = 0.1  # of the range, above and below
BLUE, ORANGE, RED = '#1e6fd0', '#e67814', '#d22828'
DASHES, DOTS = [8, 6], [2, 4]


class Plots:
    """Moved and true distance, heading and target of one robot, over time."""

    def __init__(self, gui, place):
        self._distance = _Plot(gui, place, 'distance (m)', (0.0, 1.0), [
            _series('moved', BLUE), _series('true path', ORANGE, DASHES),
            _series('target', RED, DOTS)], order=1)
        self._heading = _Plot(gui, place, 'heading (degrees)', (-5.0, 5.0), [
            _series('heading', BLUE), _series('target', RED, DOTS)], order=2)

    def draw(self, history, wanted):
        """Draw rows of time (s), moved, true distance (m), heading and target (degrees).

        :param wanted: the distance (m) at which the mover stops, negative backwards; or None
        """
        if len(history) < 2:
            return
        time, moved, true, heading, target = history.T
        goal = abs(numpy.full(len(time), wanted, dtype=float))  # NaN for None
        self._distance.draw(time, [moved, true, goal])
        self._heading.draw(time, [heading, target])


class _Plot:
    """A plot that shows a series once it has a value."""

    def __init__(self, gui, place, title, least_range, series, order):
        self._gui, self._place, self._series = gui, place, series
        y_range = {end: {'pad': MARGIN, 'soft': value, 'mode': 1}
                   for end, value in zip(('min', 'max'), least_range)}
        self._options = {
            'order': order,
            'title': title,
            'height': HEIGHT,
            'padding': PADDING,
            'legend': {'live': False},
            'scales': {'x': {'time': False}, 'y': {'range': y_range}}}
        self._shown = self._plot = None

    def draw(self, time, columns):
        """Draw a column of values for each series; NaN where a value is unknown."""
        # uPlot draws nothing if there is a NaN.
        shown = [index for index, values in enumerate(columns) if not numpy.isnan(values).all()]
        if not shown:  # as with odometry alone, of which viser makes no plot
            return
        data = (time, *(_fill(time, columns[index]) for index in shown))
        if shown == self._shown:
            self._plot.data = data
            return
        self._shown = shown
        if self._plot:
            self._plot.remove()
        with self._place:
            self._plot = self._gui.add_uplot(
                data, ({'label': 'time (s)'}, *(self._series[index] for index in shown)),
                **self._options)


def _fill(time, values):
    known = ~numpy.isnan(values)
    return numpy.interp(time, time[known], values[known])


def _series(label, colour, dash=()):
    return {
        'label': label,
        'stroke': colour,
        'width': 2,
        'points': {'show': False},
        'dash': dash}
