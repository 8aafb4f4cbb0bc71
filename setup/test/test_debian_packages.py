"""The lists of Debian packages in the docs, against the manifests and the set-up."""

import re
from xml.etree import ElementTree

from odometry_tests.scripts import ROOT

MANIFESTS = [*ROOT.glob('*/package.xml'), *ROOT.glob('docs/*/package.xml')]
# Where Debian's name is not python3- and the key.
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
    return {package for key in keys for package in DEBIAN.get(
        key, ['python3-' + re.sub('^python3-', '', key).replace('_', '-')])}


def test_a_workspace_of_your_own_gets_what_the_packages_depend_on():
    """docs/workspace.md: neither less nor more."""
    lines = re.findall(r'sudo apt install (?:--no-install-recommends )?([^`\n]*)',
                       (ROOT / 'docs' / 'workspace.md').read_text())
    installed = {word for line in lines for word in line.split()}
    assert installed == debian_packages() | TO_BUILD | DEFINITIONS | FOR_A_WINDOW
