"""A Kobuki's firmware, sensors and driver, in physics steps. No ROS."""
