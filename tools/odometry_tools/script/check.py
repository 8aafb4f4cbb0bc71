#!/usr/bin/env python3
"""Judge a node that you wrote for a tutorial."""

from odometry_tools.check.main import main

if __name__ == '__main__':
    main()
