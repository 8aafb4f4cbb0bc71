"""Tell catkin_python_setup() where the Python packages are."""

from catkin_pkg.python_setup import generate_distutils_setup
from setuptools import setup

PACKAGES = ['odometry_tools', *(f'odometry_tools.{name}' for name in ('check', 'runs', 'sweep'))]

setup(**generate_distutils_setup(packages=PACKAGES, package_dir={'': 'src'}))
