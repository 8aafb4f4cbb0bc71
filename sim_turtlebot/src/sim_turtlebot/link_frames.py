"""The frames of a robot's links for tf: what robot_state_publisher would publish."""

from geometry_msgs.msg import TransformStamped

from sim_turtlebot.description import URDF, read_joints


class LinkFrames:
    """The transforms from each link of the URDF to the links on it."""

    def __init__(self, namespace):
        """Read the URDF; the names of all frames begin with the namespace."""
        joints = [(joint, _new_transform(joint, namespace))
                  for joint in read_joints(URDF.read_text())]
        self._fixed = [transform for joint, transform in joints if joint.axis is None]
        self._moving = [(joint, transform) for joint, transform in joints if joint.axis]

    def fixed(self, stamp):
        """Return the transforms that never change."""
        for transform in self._fixed:
            transform.header.stamp = stamp
        return self._fixed

    def moving(self, stamp, angles):
        """Return the transforms of joints at angles (rad) by their names."""
        for joint, transform in self._moving:
            transform.header.stamp = stamp
            _rotate(transform, joint.rotation_at(angles[joint.name]))
        return [transform for _, transform in self._moving]


def _new_transform(joint, namespace):
    message = TransformStamped(child_frame_id=f'{namespace}{joint.child}')
    message.header.frame_id = f'{namespace}{joint.parent}'
    translation = message.transform.translation
    translation.x, translation.y, translation.z = joint.position
    _rotate(message, joint.rotation)
    return message


def _rotate(message, rotation):
    to = message.transform.rotation
    to.x, to.y, to.z, to.w = rotation
