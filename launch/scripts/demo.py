#!/usr/bin/env python3
"""Run a tutorial with a simulated TurtleBot 2 and show how it goes."""

import os
import signal

# While the imports below run, Ctrl-C ends Python without a traceback.
signal.signal(signal.SIGINT, signal.SIG_DFL)
# Nobody else is at the demo's master, for whom a namespace could be meant. rospy reads this when
# it is imported.
os.environ.pop('ROS_NAMESPACE', None)

from odometry_launch.demo import main

if __name__ == '__main__':
    main()
