"""The detector and the mover without ROS: the callbacks of their own scripts, a call at a time."""

from types import SimpleNamespace
from unittest.mock import Mock

from odometry_tests.scripts import load_script

NEEDS_ROS = {'ClosingPublisher', 'ControlLoop', 'Subscriber', 'VelocityPublisher', 'rospy',
             'warn_of_rivals', 'warn_of_two_senders'}


def _script(path):
    """Return a node's script with stand-ins for what needs ROS."""
    script = load_script(path)
    for name in NEEDS_ROS & set(vars(script)):
        setattr(script, name, Mock())
    return script


DETECTOR = _script('odom_movement_detector/src/odom_movement_detector.py')
MOVER = _script('test_movement/src/test_movement.py')


def _start(script, node, **parameters):
    """Return a node of the script with these parameters."""
    script.get_number = script.get_flag = lambda name, default, *_args: parameters.get(
        name[1:], default)
    return getattr(script, node)()


class DistanceCounter:
    """The detector: a position in, the distance that it publishes out."""

    def __init__(self, min_step=0.0, max_speed=5.0):
        """Start it with these parameters."""
        self._node = _start(DETECTOR, 'MovementDetector', min_step=min_step, max_speed=max_speed)
        self._node._publisher = self
        self.distance = 0.0

    def publish(self, distance):
        """Be the publisher."""
        self.distance = distance

    def add(self, x, y, stamp, arrival):
        """Have it hear a position (m), measured and heard at these times (s).

        :return: None, or what it warns of
        :raises ValueError: if it refuses the position
        """
        warnings = []
        DETECTOR.rospy = SimpleNamespace(
            get_time=lambda: arrival, logwarn_throttle=lambda _, text: warnings.append(text))
        self._node._on_odometry(SimpleNamespace(
            header=SimpleNamespace(stamp=SimpleNamespace(to_sec=lambda: stamp)),
            pose=SimpleNamespace(pose=SimpleNamespace(position=SimpleNamespace(x=x, y=y)))))
        return warnings[0].partition(': ')[2] if warnings else None

    def reset(self):
        """Have it count from zero again; it publishes that with the next message."""
        DETECTOR.rospy = Mock()
        self._node._on_reset(None)
        self.distance = 0.0


class Drive:
    """The mover: a distance in, the speed that it commands out."""

    def __init__(self, distance, speed, relative=False):
        """Start it with these parameters."""
        self._node = _start(
            MOVER, 'TestMovement', distance=distance, speed=speed, relative=relative)
        self._node._velocity = self

    def publish(self, linear):
        """Be the publisher."""
        self._speed = linear

    def speed_at(self, moved_distance):
        """Have it hear a distance (m); return its command (m/s)."""
        MOVER.rospy = Mock()
        self._node._control(moved_distance, 0.0)
        return self._speed
