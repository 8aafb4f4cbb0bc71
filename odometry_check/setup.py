"""Tell catkin_python_setup() where the Python package is."""

from catkin_pkg.python_setup import generate_distutils_setup
from setuptools import setup

setup(**generate_distutils_setup(packages=['odometry_check'], package_dir={'': 'src'}))
