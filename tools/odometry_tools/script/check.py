#!/usr/bin/env python3
"""Judge a node that you wrote for a tutorial."""

import os

# Nobody else is at the check's master, for whom a namespace could be meant. rospy reads this when it
# is imported.
os.environ.pop('ROS_NAMESPACE', None)

from odometry_tools.check.main import main

if __name__ == '__main__':
    main()
