"""PyBullet: the world and the robots in it. No ROS."""
