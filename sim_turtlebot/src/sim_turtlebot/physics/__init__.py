"""PyBullet: the world and what stands in it. No ROS."""
