"""Run a tutorial many times, without ROS.

The package has another name than the script sweep.py, which Python would import in its place.
"""
