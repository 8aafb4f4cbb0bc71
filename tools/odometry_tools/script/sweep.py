#!/usr/bin/env python3
"""Run a tutorial many times, over a grid of parameter values and seeds, without ROS."""

import os

# A replay has a master of its own, so a namespace makes no sense. rospy reads this on import.
os.environ.pop('ROS_NAMESPACE', None)

from odometry_tools.sweep.main import main

if __name__ == '__main__':
    main()
