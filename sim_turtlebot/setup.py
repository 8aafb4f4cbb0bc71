"""Tell catkin_python_setup() where the Python package is."""

from catkin_pkg.python_setup import generate_distutils_setup
from setuptools import setup

setup(**generate_distutils_setup(
    packages=['sim_turtlebot',
              *(f'sim_turtlebot.{room}' for room in ('physics', 'robot', 'lockstep'))],
    package_dir={'': 'src'}))
