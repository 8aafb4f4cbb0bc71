#!/usr/bin/env python3
"""Run a tutorial many times, over a grid of parameter values and seeds, without ROS."""

import os

# Nobody else is at the master of a replay, for whom a namespace could be meant. rospy reads this
# when it is imported.
os.environ.pop('ROS_NAMESPACE', None)

from odometry_sweep.main import main

if __name__ == '__main__':
    main()
