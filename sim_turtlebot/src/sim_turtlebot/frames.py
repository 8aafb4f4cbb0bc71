"""The tf frames of a robot: odom, and the URDF's, as robot_state_publisher publishes them."""

from geometry_msgs.msg import TransformStamped

from sim_turtlebot.physics.description import URDF, WHEEL_JOINTS, read_joints


class Frames:
    """The transforms from odom to base_footprint, and from each URDF link to its children."""

    def __init__(self, robot):
        """Read the URDF; the robot's namespace is the prefix of all frames."""
        self._robot, namespace = robot, robot.namespace
        self._base = _new_transform(f'{namespace}odom', f'{namespace}base_footprint')
        joints = [(joint, _new_transform(f'{namespace}{joint.parent}', f'{namespace}{joint.child}'))
                  for joint in read_joints(URDF.read_text())]
        self._fixed = [pair for pair in joints if not pair[0].axis]
        self._wheels = [pair for pair in joints if pair[0].axis]

    def fixed(self, stamp):
        """Return the transforms that never change."""
        return [_filled(transform, stamp, joint.position, joint.rotation)
                for joint, transform in self._fixed]

    def base(self, stamp):
        """Return the transform from odom to base_footprint."""
        return _filled(self._base, stamp, *self._robot.odometry[:2])

    def wheels(self, stamp):
        """Return the transforms from base_link to the wheels."""
        angles = dict(zip(WHEEL_JOINTS, self._robot.wheels[0]))
        return [_filled(transform, stamp, joint.position, joint.rotation_at(angles[joint.name]))
                for joint, transform in self._wheels]


def _filled(transform, stamp, position, orientation):
    """Return a TransformStamped with this rospy.Time, position and quaternion (x, y, z, w)."""
    transform.header.stamp = stamp
    fill_pose(transform.transform.translation, transform.transform.rotation, position, orientation)
    return transform


def read_pose(pose):
    """Return the position (x, y, z; m) and the quaternion (x, y, z, w) of a geometry_msgs/Pose."""
    position, turn = pose.position, pose.orientation
    return (position.x, position.y, position.z), (turn.x, turn.y, turn.z, turn.w)


def fill_pose(to_position, to_orientation, position, orientation):
    """Write a position and a quaternion (x, y, z, w) into messages."""
    to_position.x, to_position.y, to_position.z = position
    to_orientation.x, to_orientation.y, to_orientation.z, to_orientation.w = orientation


def _new_transform(parent, child):
    transform = TransformStamped(child_frame_id=child)
    transform.header.frame_id = parent
    return transform
