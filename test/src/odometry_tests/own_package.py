"""A catkin package of the user's own."""

MANIFEST = """<package format="3">
  <name>{name}</name>
  <version>1.0.0</version>
  <description>A package of the user's own.</description>
  <maintainer email="me@example.com">Me</maintainer>
  <license>BSD</license>
  <buildtool_depend>catkin</buildtool_depend>
</package>
"""
# As teleop_twist_keyboard has it: CMake then looks for compilers.
CMAKE = """cmake_minimum_required(VERSION 3.0.2)
project({name})
find_package(catkin REQUIRED)
catkin_package()
catkin_install_python(PROGRAMS hello.py DESTINATION ${{CATKIN_PACKAGE_BIN_DESTINATION}})
"""
HELLO = """#!/usr/bin/env python3
import {module}
print("hello from", {module}.__name__)
"""


def make_package(folder, module):
    """Make a package of the folder's name, whose hello.py greets from a module that it imports."""
    folder.mkdir(parents=True)
    for name, content in (('package.xml', MANIFEST), ('CMakeLists.txt', CMAKE), ('hello.py', HELLO)):
        (folder / name).write_text(content.format(name=folder.name, module=module))
    (folder / 'hello.py').chmod(0o755)
