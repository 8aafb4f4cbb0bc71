"""The physics: a floor and TurtleBots in PyBullet, driven by their wheel motors.

The solver and its settings were chosen by measurement. Millimetres from the straight line after
10 m at 0.5 m/s along x, of the centre in a spin at 1.5 rad/s, and from the start after three laps
of 0.4 m radius; us per step, at 0.1 to 0.7 m/s and in spins of 1 and 3 rad/s, all measured in one
run. In other directions the line is missed by up to 1.5 mm, without constraint force mixing by up
to 3.8 mm:

    direct (Dantzig), 240 Hz                       0.0   0.01   2.3   15
    without constraint force mixing                0.5   0.04   3.0   25 to 41
    without the two contact thresholds             0.0   0.01   2.3   22 to 47
    without either                                 0.1   0.04   3.0   22 to 86
    direct (Dantzig), 120 Hz                       0.0   0.01   1.1   15 to 29
    iterative, 50 iterations, 240 Hz               1.9   0.19   4.9   35 to 58
"""

from odometry_common.native_output import suppressed_output

from sim_turtlebot.physics.turtlebot import LARGEST_OVERLAP, TurtleBot
from sim_turtlebot.physics.world_file import WorldFileError, check_world_file, load

with suppressed_output():
    import pybullet
    from pybullet_utils.bullet_client import BulletClient

GRAVITY = 9.80665  # m/s^2, standard gravity
FLOOR_FRICTION = 1.0
SETTLING_TIME = 1.0  # s; dropped onto its wheels, the robot is still after half of that
# Constraint force mixing, next to none. Two wheels on one axle hold the robot sideways twice;
# without it the solver searches, at each step, for one of infinitely many solutions.
CFM = 1e-9
# Share of a shape's size. With PyBullet's 0.02 up to four old contact points stay on a rolling
# wheel, and the solver's cost grows with the cube of their number.
CONTACT_BREAKING_THRESHOLD = 0.05
FEWEST_AT_ONCE = 4  # steps; for fewer, changing the number takes longer than it saves
CAMERA = 1.5, -60.0, -30.0  # distance (m), yaw and pitch (degrees) of the window's camera


class World:
    """A floor, whatever a world file adds, and TurtleBots that stand at their starts."""

    def __init__(self, step_rate, starts, gui=False, world_file=''):
        """Build a world that advances 1/step_rate seconds with each step.

        :param starts: x, y (m) and yaw (rad) of each robot
        :param world_file: path of a URDF or SDF file to load beside the floor
        :raises sim_turtlebot.physics.world_file.WorldFileError: if the file cannot be loaded, or
            leaves no room for a robot at its start
        """
        self._step_rate = step_rate
        self._world_file = world_file
        with suppressed_output():
            self.client = BulletClient(pybullet.GUI if gui else pybullet.DIRECT)
        # Bound once, as those of a TurtleBot are.
        self._call = self.client.stepSimulation
        # A mouse in the window, or gravity, may move other things.
        self.only_robots_move = not gui and not world_file
        self._gui = gui
        if gui:
            self.client.configureDebugVisualizer(pybullet.COV_ENABLE_GUI, 0)
        if world_file:
            check_world_file(world_file)
        # Without a window nothing shows the shapes, and they take most of the loading time.
        flags = 0 if gui else pybullet.URDF_IGNORE_VISUAL_SHAPES
        self.robots = [TurtleBot(self.client, *start, flags) for start in starts]
        self._build()

    def step(self, steps=1):
        """Let 1/step_rate seconds pass `steps` times, in few calls of PyBullet."""
        # By a power of two a float is multiplied and divided exactly: no step changes by a bit.
        at_once = steps & -steps
        if at_once < FEWEST_AT_ONCE:
            at_once = 1
        if at_once != self._steps_at_once:
            self._set_steps_at_once(at_once)
        for _ in range(steps // at_once):
            self._call()

    def restart(self):
        """Put each robot at its start again, at rest; nothing else is reset.

        A robot that has touched only the floor then moves as after rebuild(), which takes longer.
        """
        for robot in self.robots:
            robot.place_at_start()

    def rebuild(self):
        """Put everything back as it was after __init__(), to the last bit.

        PyBullet's restoreState() does not: robots that have touched something then move
        differently in the last digits. PyBullet keeps the world file in memory.
        """
        self.client.resetSimulation()
        self._build()

    def look_at(self, robot):
        """Let the window's camera follow the robot."""
        self.client.resetDebugVisualizerCamera(*CAMERA, robot.pose()[0])

    def _build(self):
        """Load the floor, the world file and the robots; let these sink onto their wheels."""
        self._draw(False)
        self._steps_at_once = 1
        with suppressed_output():
            self._configure()
            floor = self.client.createMultiBody(
                0, self.client.createCollisionShape(pybullet.GEOM_PLANE))
            self.client.changeDynamics(floor, -1, lateralFriction=FLOOR_FRICTION)
            if self._world_file:
                load(self.client, self._world_file)
            for robot in self.robots:
                robot.load()
        if self._world_file:
            self._check_starts()
        self.step(round(SETTLING_TIME * self._step_rate))
        for robot in self.robots:
            robot.settle_here()
        self._draw(True)

    def _draw(self, whether):
        """Draw the window or not; while it is drawn, loading a shape waits for a frame."""
        if self._gui:
            self.client.configureDebugVisualizer(pybullet.COV_ENABLE_RENDERING, whether)

    def _configure(self):
        client = self.client
        client.setGravity(0, 0, -GRAVITY)
        # The direct solver keeps the robot straighter than the iterative one in half the time.
        # Its cost grows with the cube of its task, so each robot is a separate task.
        client.setPhysicsEngineParameter(
            fixedTimeStep=1 / self._step_rate, numSubSteps=0,
            constraintSolverType=pybullet.CONSTRAINT_SOLVER_LCP_DANTZIG,
            globalCFM=CFM, contactBreakingThreshold=CONTACT_BREAKING_THRESHOLD,
            minimumSolverIslandSize=1)

    def _set_steps_at_once(self, steps):
        self._steps_at_once = steps
        self.client.setPhysicsEngineParameter(
            fixedTimeStep=steps / self._step_rate, numSubSteps=steps if steps > 1 else 0)
        for robot in self.robots:
            robot.steps_at_once = steps

    def _check_starts(self):
        self.client.performCollisionDetection()
        for number, robot in enumerate(self.robots, 1):
            overlap = robot.overlap()
            if overlap > LARGEST_OVERLAP:
                name = f'robot_{number}' if len(self.robots) > 1 else 'the robot'
                x, y, _ = robot.pose()[0]
                raise WorldFileError('a world that leaves room for the robot at its start ('
                                     f'{name}, at x {x:g}, y {y:g}, is {overlap:.3f} m deep in it)')
