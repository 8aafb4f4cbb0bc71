"""The tf frames of a robot: odom, and the URDF's, as robot_state_publisher publishes them."""

from geometry_msgs.msg import Quaternion, Transform, TransformStamped, Vector3
from std_msgs.msg import Header

from sim_turtlebot.physics.description import URDF, WHEEL_JOINTS, read_joints


class Frames:
    """The transforms from odom to base_footprint, and from each URDF link to its children."""

    def __init__(self, robot, publish_tf):
        """Read the URDF; the robot's namespace is the prefix of all frames.

        :param publish_tf: whether the transform from odom is among them
        """
        self._robot, self._publish_tf = robot, publish_tf
        self._joints = read_joints(URDF.read_text())

    def fixed(self, stamp):
        """Return the transforms that never change."""
        return [self._transform(stamp, joint.parent, joint.child, joint.position, joint.rotation)
                for joint in self._joints if not joint.axis]

    def moving(self, stamp):
        """Return the transforms from odom to base_footprint, and from base_link to the wheels."""
        angles = dict(zip(WHEEL_JOINTS, self._robot.wheels[0]))
        moving = [self._transform(stamp, joint.parent, joint.child, joint.position,
                                  joint.rotation_at(angles[joint.name]))
                  for joint in self._joints if joint.axis]
        if self._publish_tf:
            moving.insert(0, self._transform(
                stamp, 'odom', 'base_footprint', *self._robot.odometry[:2]))
        return moving

    def _transform(self, stamp, parent, child, position, orientation):
        prefix = self._robot.namespace
        return TransformStamped(Header(0, stamp, prefix + parent), prefix + child,
                                Transform(Vector3(*position), Quaternion(*orientation)))


def read_pose(pose):
    """Return the position (x, y, z; m) and the quaternion (x, y, z, w) of a geometry_msgs/Pose."""
    position, turn = pose.position, pose.orientation
    return (position.x, position.y, position.z), (turn.x, turn.y, turn.z, turn.w)
