"""The numbers of a Kobuki, the base of a TurtleBot 2, with their sources."""

import math

WHEEL_RADIUS = 0.035  # m, kobuki_description
WHEEL_SEPARATION = 0.230  # m, kobuki_description
TICKS_PER_TURN = 2578.33  # of a wheel's encoder, Kobuki user guide

# x, y, z (m) in base_footprint of the Asus Xtion Pro that a TurtleBot 2 carries:
# turtlebot_description, urdf/turtlebot_properties.urdf.xacro and
# urdf/sensors/asus_xtion_pro.urdf.xacro.
DEPTH_CAMERA = (-0.087, 0.0135, 0.2972)
DEPTH_CAMERA_FRAME = 'camera_depth_frame'

MAX_LINEAR_SPEED = 0.7  # m/s, TurtleBot 2 specification
MAX_ANGULAR_SPEED = math.pi  # rad/s, 180 degrees/s, TurtleBot 2 specification
CMD_VEL_TIMEOUT = 0.6  # s, kobuki_node

# The stall torque of the motor, 33 mN m, times its gear ratio of 49.5833 (Kobuki user guide):
# enough for the wheels to slip at a wall.
WHEEL_TORQUE = 1.64  # N m
# m/s^2 of each wheel: the motors' rated load of 5 mN m, times the same ratio, accelerates a
# TurtleBot 2 of 4.94 kg by this. The stall torque would tip it over.
MAX_WHEEL_ACCELERATION = 2.9
