"""The sweep: a tutorial many times, without ROS.

The package is not named after the script sweep.py, which would be imported in its stead.
"""
