"""A TurtleBot 2 in PyBullet: physics, the robot on top of it, and the ROS node on top of both."""
