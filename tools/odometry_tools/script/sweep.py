#!/usr/bin/env python3
"""Run a tutorial, or a launch file, many times, over a grid of parameter values and seeds."""

from odometry_tools.sweep.main import main

if __name__ == '__main__':
    main()
