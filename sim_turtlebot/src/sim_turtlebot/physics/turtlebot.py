"""The body of a TurtleBot 2 in PyBullet: wheels, pose and contacts."""

import contextlib
import os
from functools import partial

from odometry_common.native_output import suppressed_output

from sim_turtlebot.kobuki import WHEEL_RADIUS, WHEEL_TORQUE
from sim_turtlebot.physics.description import BASE_JOINT, URDF, WHEEL_JOINTS, without_frames

with suppressed_output():
    import pybullet

NORMAL, DISTANCE = 7, 8  # places in a point of getContactPoints()
LARGEST_OVERLAP = 1e-3  # m, of a robot and the world where it is put; more would throw it away
UPWARDS = 0.9  # share of a contact's force that lifts the robot, if it is a floor's
HIGHEST_FLOOR = 0.05  # m; a floor of the world's own lifts the robot gently, up to this height
AIR = 10.0  # m, above anything that a robot could touch
# m; the solver skips the floor below the base and a raised caster.
CONTACT_PROCESSING_THRESHOLD = 1e-3
FOOTPRINT_MASS = 1e-4  # kg; PyBullet gives 1 kg to a link without <inertial>


class TurtleBot:
    """One TurtleBot 2 in a world: its motors, its pose and its wheels."""

    def __init__(self, client, x, y, yaw, flags):
        """Take a start in a PyBullet client's World, for load(): x, y (m) and yaw (rad)."""
        self._client = client
        self._start = [x, y, 0.0], client.getQuaternionFromEuler([0, 0, yaw])
        self._flags = flags
        self._settled_height = 0.0

    def load(self):
        """Load the robot at its start, into a world without it."""
        client = self._client
        with _in_memory(without_frames(URDF.read_text())) as path:
            self._body = client.loadURDF(path, *self._start, flags=self._flags)
        # The footprint is PyBullet's base link: its pose is the robot's without conversion.
        client.changeDynamics(self._body, -1, mass=FOOTPRINT_MASS,
                              localInertiaDiagonal=[FOOTPRINT_MASS * WHEEL_RADIUS**2] * 3)
        joints = {client.getJointInfo(self._body, index)[1].decode(): index
                  for index in range(client.getNumJoints(self._body))}
        client.changeDynamics(self._body, joints[BASE_JOINT],
                              contactProcessingThreshold=CONTACT_PROCESSING_THRESHOLD)
        self._wheels = [joints[name] for name in WHEEL_JOINTS]
        # Bound once: the client creates such a function at each access.
        # Position (x, y, z; m) and orientation (x, y, z, w) of the footprint.
        self.pose = partial(client.getBasePositionAndOrientation, self._body)
        # Linear (m/s) and angular (rad/s) velocity in the world frame, three of each.
        self.velocity = partial(client.getBaseVelocity, self._body)
        self._get_wheels = partial(client.getJointStates, self._body, self._wheels)
        # Per call of PyBullet, which treats a torque as if it acted in a single step.
        self.steps_at_once = 1
        self.drive(0.0, 0.0)

    def drive(self, left, right):
        """Turn the wheels so that their rims move at these speeds (m/s)."""
        self._client.setJointMotorControlArray(
            self._body, self._wheels, pybullet.VELOCITY_CONTROL,
            targetVelocities=[left / WHEEL_RADIUS, right / WHEEL_RADIUS],
            forces=[WHEEL_TORQUE / self.steps_at_once] * 2)

    def wheels(self):
        """Return angles (rad), velocities (rad/s) and torques (N m) of the left and right wheel."""
        left, right = self._get_wheels()
        steps = self.steps_at_once
        return (left[0], right[0]), (left[1], right[1]), (left[3] * steps, right[3] * steps)

    def cast_rays(self, starts, ends):
        """Return at which share of its length each ray meets another body; 1.0 if at none.

        A ray that starts inside one of the robot's own shapes leaves it without meeting it.

        :param starts, ends: lists of x, y, z (m) in the frame of the footprint
        """
        hits = self._client.rayTestBatch(starts, ends, parentObjectUniqueId=self._body)
        return [hit[2] for hit in hits]

    def overlap(self):
        """Return how deep (m) other bodies overlap the robot, except a floor it stands on."""
        points = [(point[NORMAL][2], -point[DISTANCE])
                  for point in self._client.getContactPoints(self._body)]
        return max((depth for up, depth in points
                    if up < UPWARDS or depth > HIGHEST_FLOOR), default=0.0)

    def place(self, position, orientation, wheel_angles):
        """Put the robot there, at rest; m, quaternion x y z w, rad."""
        self._client.resetBasePositionAndOrientation(self._body, position, orientation)
        self._client.resetBaseVelocity(self._body, [0, 0, 0], [0, 0, 0])
        for wheel, angle in zip(self._wheels, wheel_angles):
            self._client.resetJointState(self._body, wheel, angle, 0.0)

    def put(self, position, orientation, wheel_angles):
        """Place the robot at rest; if there is no room, stop it where it is.

        :param position: x, y, z (m); z is 0 where it stands on the floor
        :param orientation, wheel_angles: as for place()
        :raises ValueError: if it would overlap something
        """
        here = self.pose()
        x, y, z = position
        self.place([x, y, z + self._settled_height], orientation, wheel_angles)
        self.drive(0.0, 0.0)
        self._client.performCollisionDetection()
        overlap = self.overlap()
        if overlap > LARGEST_OVERLAP:
            self.place(*here, wheel_angles)
            raise ValueError(f'at x {x:g}, y {y:g}, z {z:g} the robot would be {overlap:.3f} m '
                             'deep in something, but there must be room for it')

    def place_at_start(self):
        """Go back to where the robot was added, with its wheels at zero and at rest.

        Lift it first: a body that moves only a little keeps its contacts in PyBullet, and the
        next drive would depend on the last one.
        """
        (x, y, _), orientation = self._start
        self.place([x, y, AIR], orientation, [0.0, 0.0])
        self._client.performCollisionDetection()
        self.place([x, y, self._settled_height], orientation, [0.0, 0.0])
        self.drive(0.0, 0.0)

    def settle_here(self):
        """Keep the height at which the robot has settled, at its exact start."""
        self._settled_height = self.pose()[0][2]
        self.place_at_start()


@contextlib.contextmanager
def _in_memory(text):
    """Yield the path of a file with this text in memory: a disk may be full, or read-only."""
    with open(os.memfd_create('turtlebot2.urdf'), 'w', encoding='utf-8') as file:
        file.write(text)
        file.flush()
        yield f'/proc/self/fd/{file.fileno()}'
