"""The picture that a demo and a replay leave beside their bag."""

import math
import os

from odometry_launch.output import complain
from odometry_launch.run_plot import BagError, make_figure, read_run


def leave_picture(bag, end=math.inf):
    """Draw the run in a bag (a Path), and print where the picture is, or why there is none.

    :param end: of the run (s)
    """
    picture = bag.with_suffix('.png')
    try:
        make_figure(read_run(bag, end=end)).savefig(str(picture))
    except (OSError, BagError) as error:
        complain(f'no picture: {error}')
    else:
        print(f'picture         {os.path.relpath(picture)}', flush=True)
