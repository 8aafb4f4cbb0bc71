"""Inputs by which the page puts a simulated robot somewhere."""

import math
import threading

import rospy
from geometry_msgs.msg import Point, Pose, PoseStamped, Quaternion
from odometry_common.connections import is_heard_within
from sim_turtlebot.poses import MAX_COORDINATE

from robot_view.panel import NODE

FINENESS, ANGLE_FINENESS = 0.05, 5.0  # m and degrees, of the inputs' buttons
CONNECTING_TIMEOUT = 2.0  # s
LABEL = 'put here'


class PlacingInputs:
    """A place in the world, and a button that puts the chosen robot there, at rest."""

    def __init__(self, gui, chosen):
        """Add them; `chosen` is a function that returns the namespace of a robot."""
        self._chosen = chosen
        self._publishers = {}
        self._lock = threading.Lock()
        folder = gui.add_folder('put the robot', expand_by_default=False)
        with folder:
            self._x, self._y = (
                gui.add_number(f'{name} (m)', 0.0, min=-MAX_COORDINATE, max=MAX_COORDINATE,
                               step=FINENESS) for name in 'xy')
            self._heading = gui.add_number(
                'heading (degrees)', 0.0, min=-360.0, max=360.0, step=ANGLE_FINENESS)
            button = gui.add_button(LABEL)
        button.on_click(self._put)
        self._handles = folder, self._x, self._y, self._heading, button
        self.show(False)

    def show(self, visible):
        """Show or hide them; nobody can use hidden ones."""
        # Each of them: messages.checked() looks at an input, and not at the folder that it is in.
        for handle in self._handles:
            handle.visible = visible

    def _put(self, event):
        publisher = self._publisher(self._chosen())
        if is_heard_within(publisher, CONNECTING_TIMEOUT):
            publisher.publish(_pose(self._x.value, self._y.value, self._heading.value))
        else:
            event.client.add_notification(LABEL, f'nobody listens on {publisher.name}',
                                          auto_close_seconds=10)

    def _publisher(self, namespace):
        with self._lock:
            if namespace not in self._publishers:
                self._publishers[namespace] = rospy.Publisher(
                    f'{NODE}/{namespace}set_pose', PoseStamped, queue_size=1)
            return self._publishers[namespace]


def _pose(x, y, heading):
    """Return the PoseStamped of a robot on the floor of the world; m, m, degrees."""
    half = math.radians(heading) / 2
    message = PoseStamped(pose=Pose(
        Point(x, y, 0.0), Quaternion(0.0, 0.0, math.sin(half), math.cos(half))))
    message.header.frame_id = 'world'
    return message
