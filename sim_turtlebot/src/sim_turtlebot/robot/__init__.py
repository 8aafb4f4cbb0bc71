"""What a Kobuki's firmware, sensors and driver do, in physics steps. No ROS."""
