#!/usr/bin/env python3
"""Run a tutorial with a simulated TurtleBot 2 and show how it goes."""

from odometry_launch.demo import main

if __name__ == '__main__':
    main()
