#!/usr/bin/env python3
"""Run a tutorial many times, over a grid of parameter values and seeds, without ROS."""

from odometry_tools.sweep.main import main

if __name__ == '__main__':
    main()
