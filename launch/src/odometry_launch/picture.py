"""The picture that a demo and a replay leave beside their bag."""

import math
import os

from run_plot.figure import make_figure
from run_plot.recorded_run import BagError, read_run

from odometry_launch.output import complain


def leave_picture(bag, end=math.inf, **targets):
    """Draw the run in a bag (a Path), and print where the picture is, or why it failed.

    :param end: of the run (s)
    :param targets: as for make_figure()
    """
    picture = bag.with_suffix('.png')
    try:
        make_figure(read_run(bag, end=end), **targets).savefig(str(picture))
    except (OSError, BagError) as error:
        complain(f'no picture: {error}')
    else:
        print(f'picture         {os.path.relpath(picture)}', flush=True)
