"""A viewer, and a robot that its page shows and drives."""

import contextlib

import numpy
import pytest
from geometry_msgs.msg import Twist

from odometry_tests.processes import hold_port, rosrun
from odometry_tests.tutorial import Truth, speed
from odometry_tests.waiting import Recorder, wait_until

MOVING = 0.05  # m/s
STOPPING_TIME = 0.4  # s, from a zero to a robot at rest
REACTION_TIME = 0.5  # s; beside the robot, a browser keeps two processors busy
ROBOT_PIXELS = 100  # at least so many are the robot's
PICTURE_TIMEOUT = 20.0  # s; the page draws seldom while tests run
PICTURE_PERIOD = 0.2  # s
DARK = 80  # of 255; the robot is darker than this, the floor and the marks are not


class View:
    """A viewer and where its page is."""

    def __init__(self, *arguments):
        """Start it on a free port; without viser the test that needs it is skipped."""
        pytest.importorskip('viser', reason='viser is not installed')
        self._port = contextlib.ExitStack()
        port = self._port.enter_context(hold_port())
        self.process = rosrun('sim_turtlebot', 'view.py', f'_port:={port}', *arguments)
        self.url = f'http://localhost:{port}'

    def __enter__(self):
        """Return once it says where the page is."""
        try:
            self.process.wait_for_output(f'view: {self.url}', timeout=20.0)
        except AssertionError:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        """End it."""
        self.process.__exit__()
        self._port.close()


class Motion(Truth):
    """What a robot does, and in `commands` what it is told."""

    def __init__(self, namespace=''):
        """Record both."""
        super().__init__(namespace)
        self.commands = Recorder(f'{namespace}cmd_vel', Twist)
        self.wait_for(timeout=20.0)

    def assert_it_stops(self, within):
        """Assert that a moving robot rests soon, and that after `within` seconds nobody drives it."""
        start = self.stamp
        self.wait_seconds(within)
        count = len(self.commands.messages)
        self.wait_seconds(1.0)
        late = self.commands.messages[count:]
        assert not late, f'{len(late)} commands came late, the first of them\n{late[0]}'
        assert self.commands.last == Twist(), 'the last command is not zero'
        took = max(message.header.stamp.to_sec() - start for message in self.messages
                   if speed(message) > MOVING)
        assert took <= within + STOPPING_TIME, f'it went on for {took:.2f} s'
        self.wait_until_resting()


def dark_pixels(picture):
    """Return rows and columns of the pixels that are as dark as the robot."""
    return numpy.nonzero(picture.max(axis=2) < DARK)


def wait_for_robot(page, accepts=lambda rows, columns: True):
    """Return rows and columns of its pixels once the page has drawn it and they are accepted."""
    seen = []

    def robot():
        seen[:] = dark_pixels(page.scene())
        return len(seen[0]) > ROBOT_PIXELS and accepts(*seen)

    wait_until(robot, PICTURE_TIMEOUT, lambda: f'the robot in the picture; dark are {seen}',
               PICTURE_PERIOD)
    return seen
