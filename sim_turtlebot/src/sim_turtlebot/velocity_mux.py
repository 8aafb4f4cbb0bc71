"""Which of several controllers a TurtleBot obeys, as yocs_cmd_vel_mux decides it on the robot."""

import math
from typing import NamedTuple


class Input(NamedTuple):
    """An input of the multiplexer."""

    priority: int  # no two have the same
    timeout: float  # s


# By topic: turtlebot_bringup/param/mux.yaml in github.com/turtlebot/turtlebot, but for the safety
# controller, which needs bumpers.
INPUTS = {'cmd_vel_mux/input/teleop': Input(7, 1.0), 'cmd_vel_mux/input/navi': Input(5, 1.0)}


class VelocityMux:
    """Passes on the commands of one input at a time.

    The active input blocks those of a lower priority until it has been silent for its timeout:
    yocs_cmd_vel_mux/src/cmd_vel_mux_nodelet.cpp in github.com/yujinrobot/yujin_ocs.
    """

    def __init__(self):
        """Let every input through."""
        self.restart()

    def restart(self):
        """Let every input through again."""
        self._priority, self._end = 0, -math.inf

    def passes(self, name, now):
        """Return whether a command that comes from an input at a time (ns) goes on to the base."""
        priority, timeout = INPUTS[name]
        if now < self._end and priority < self._priority:
            return False
        self._priority, self._end = priority, now + round(timeout * 1e9)
        return True
