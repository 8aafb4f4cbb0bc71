"""The tf frames of a robot: odom, and the URDF's, as robot_state_publisher publishes them."""

from geometry_msgs.msg import TransformStamped

from sim_turtlebot.physics.description import URDF, WHEEL_JOINTS, read_joints


class Frames:
    """The transforms from odom to base_footprint, and from each link of the URDF to its children."""

    def __init__(self, robot, namespace):
        """Read the URDF; the namespace is the prefix of all frames."""
        self._robot = robot
        self._base = _new_transform(f'{namespace}odom', f'{namespace}base_footprint')
        self._fixed, self._wheels = [], {}
        for joint in read_joints(URDF.read_text()):
            transform = _new_transform(f'{namespace}{joint.parent}', f'{namespace}{joint.child}')
            fill_pose(transform.transform.translation, transform.transform.rotation,
                      joint.position, joint.rotation)
            if joint.axis:
                self._wheels[joint.name] = joint, transform
            else:
                self._fixed.append(transform)

    def fixed(self, stamp):
        """Return the transforms that never change."""
        for transform in self._fixed:
            transform.header.stamp = stamp
        return self._fixed

    def base(self, stamp):
        """Return the transform from odom to base_footprint."""
        self._base.header.stamp = stamp
        odometry, transform = self._robot.odometry, self._base.transform
        fill_pose(transform.translation, transform.rotation, *odometry[:2])
        return self._base

    def wheels(self, stamp):
        """Return the transforms from base_link to the wheels."""
        angles = dict(zip(WHEEL_JOINTS, self._robot.wheels[0]))
        for name, (joint, transform) in self._wheels.items():
            transform.header.stamp = stamp
            fill_pose(transform.transform.translation, transform.transform.rotation,
                      joint.position, joint.rotation_at(angles[name]))
        return [transform for _, transform in self._wheels.values()]


def fill_pose(to_position, to_orientation, position, orientation):
    """Write a position and a quaternion (x, y, z, w) into messages."""
    to_position.x, to_position.y, to_position.z = position
    to_orientation.x, to_orientation.y, to_orientation.z, to_orientation.w = orientation


def _new_transform(parent, child):
    transform = TransformStamped(child_frame_id=child)
    transform.header.frame_id = parent
    return transform
