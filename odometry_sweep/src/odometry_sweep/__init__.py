"""Run a tutorial many times, without ROS.

The package cannot be called sweep: Python would import the script sweep.py instead.
"""
