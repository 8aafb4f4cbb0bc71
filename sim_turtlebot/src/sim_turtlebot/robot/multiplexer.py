"""Choose which of several controllers drives, as yocs_cmd_vel_mux does on a TurtleBot."""

import math

# Priorities by topic, and the timeout of each: turtlebot_bringup/param/mux.yaml in
# github.com/turtlebot/turtlebot, without the safety controller, which needs bumpers.
INPUTS = {'cmd_vel_mux/input/teleop': 7, 'cmd_vel_mux/input/navi': 5}
TIMEOUT = 1.0  # s


class VelocityMux:
    """Passes on the commands of one input at a time.

    The active input blocks those of a lower priority until it has been silent for its timeout:
    yocs_cmd_vel_mux/src/cmd_vel_mux_nodelet.cpp in github.com/yujinrobot/yujin_ocs.
    """

    def __init__(self, step_rate):
        """Count time in steps, so many in a second; block no input."""
        self._timeout = TIMEOUT * step_rate
        self._priority, self._end = 0, -math.inf

    def passes(self, name, now):
        """Return whether a command reaches the base.

        :param name: its topic; one that is not an input bypasses the multiplexer
        :param now: the current step
        """
        priority = INPUTS.get(name)
        if priority is None:
            return True
        if now < self._end and priority < self._priority:
            return False
        self._priority, self._end = priority, now + self._timeout
        return True
