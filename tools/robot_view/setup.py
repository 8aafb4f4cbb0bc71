"""Tell catkin_python_setup() where the Python package is."""

from catkin_pkg.python_setup import generate_distutils_setup
from setuptools import setup

setup(**generate_distutils_setup(
    packages=['robot_view'], package_dir={'': 'src'},
    package_data={'robot_view': ['*.css', '*.html', '*.js']}))
