"""The picture that a demo and a replay leave beside their bag."""

import os

from odometry_launch.output import complain
from odometry_launch.run_plot import BagError, make_figure, read_run


def leave_picture(bag):
    """Draw the run in a bag (a Path), and print where the picture is, or why there is none."""
    picture = bag.with_suffix('.png')
    try:
        make_figure(read_run(bag)).savefig(str(picture))
    except (OSError, BagError) as error:
        complain(f'no picture: {error}')
    else:
        print(f'picture         {os.path.relpath(picture)}', flush=True)
