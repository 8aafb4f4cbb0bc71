#!/usr/bin/env python3
"""Judge a node that you wrote for a tutorial."""

import sys

# Remappings are for the learner's node. rospy, when it is imported, would take them for itself.
ARGUMENTS = sys.argv[1:]
del sys.argv[1:]

from odometry_tools.check.main import main

if __name__ == '__main__':
    main(ARGUMENTS)
