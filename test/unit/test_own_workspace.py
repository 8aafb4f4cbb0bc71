"""docs/workspace.md has Debian install what every package.xml names, and what builds it."""

import re
from xml.etree import ElementTree

from odometry_tests.scripts import ROOT

PAGE = (ROOT / 'docs' / 'workspace.md').read_text()
MANIFESTS = [*ROOT.glob('*/package.xml'), *ROOT.glob('docs/*/package.xml')]
# Where Debian's name is not python3- and the key's.
DEBIAN = {'catkin': ['catkin'], 'rosbash': ['rosbash'],
          'rostest': ['python3-rostest', 'librostest-dev'], 'rviz': ['rviz']}
TO_BUILD = {'g++', 'git', 'make', 'python3-dev', 'python3-venv', 'ros-environment'}
# Of messages and services, for rosmsg, rossrv and completion.
DEFINITIONS = {'libnav-msgs-dev', 'libsensor-msgs-dev', 'libstd-srvs-dev', 'ros-geometry-msgs',
               'ros-nav-msgs', 'ros-rosgraph-msgs', 'ros-roscpp-msg', 'ros-sensor-msgs',
               'ros-std-msgs', 'ros-std-srvs', 'ros-tf2-msgs'}
FOR_A_WINDOW = {'libgl1', 'libx11-6'}


def debian_packages():
    """Return what Debian calls the dependencies of all packages here."""
    roots = [ElementTree.parse(manifest).getroot() for manifest in MANIFESTS]
    keys = {element.text for root in roots for element in root if element.tag.endswith('depend')}
    keys -= {root.findtext('name') for root in roots}
    return {package for key in keys for package in DEBIAN.get(key, [in_debian(key)])}


def in_debian(key):
    """Return what Debian calls a Python package or the messages of a package."""
    return 'python3-' + re.sub('^python3-', '', key).replace('_', '-')


def test_the_page_installs_what_the_packages_depend_on():
    """Neither less nor more."""
    lines = re.findall(r'sudo apt install (?:--no-install-recommends )?([^`\n]*)', PAGE)
    installed = {word for line in lines for word in line.split()}
    assert installed == debian_packages() | TO_BUILD | DEFINITIONS | FOR_A_WINDOW
