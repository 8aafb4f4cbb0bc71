"""Figures of matplotlib, for files."""

import os

# A Jupyter cell or an editor sets a backend for its own windows, which may not be installed here.
os.environ['MPLBACKEND'] = 'agg'

from matplotlib.figure import Figure

RESOLUTION = 100  # dots per inch


def new_figure(width, height):
    """Return an empty Figure of this size (inches)."""
    return Figure((width, height), dpi=RESOLUTION, layout='constrained')
