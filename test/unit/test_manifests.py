"""Each package.xml names what the package uses, and docs/workspace.md what is installed for that."""

import ast
import importlib.util
import re
from xml.etree import ElementTree

import pytest
from odometry_tests.scripts import PACKAGES, ROOT

MANIFESTS = [package / 'package.xml' for package in [*PACKAGES, ROOT / 'docs/example']]
OPTIONAL = {'amcl', 'gmapping', 'map_server', 'move_base', 'robot_view', 'rviz', 'tf'}
KEYS = {'PIL': 'python3-pil', 'matplotlib': 'python3-matplotlib', 'numpy': 'python3-numpy',
        'psutil': 'python3-psutil', 'pytest': 'python3-pytest', 'rospkg': 'python3-rospkg', 'yaml': 'python3-yaml'}
# Where Debian's name is not python3- and the key.
DEBIAN = {'catkin': ['catkin'], 'rosbash': ['rosbash'],
          'rostest': ['python3-rostest', 'librostest-dev']}
# The lists in the set-up, by name.
PARTS = {name: words.split() for name, words in re.findall(
    r'^(\w+)_PARTS=\(([^)]*)\)', (ROOT / 'tools/setup/set_up.bash').read_text(), re.MULTILINE)}


def name_of(manifest):
    return ElementTree.parse(manifest).findtext('name')


# A module here may have another name than the package that it comes from.
KEYS.update((module.parent.name, name_of(manifest)) for manifest in MANIFESTS
            for module in manifest.parent.glob('src/*/__init__.py'))


def depends(manifest):
    return {element.text for element in ElementTree.parse(manifest).getroot()
            if element.tag.endswith('depend')}


def imports(tree):
    """Return the top-level modules that a syntax tree imports from elsewhere."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name.partition('.')[0] for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and not node.level:
            yield node.module.partition('.')[0]


def is_installed(module):
    """Return whether a module comes from ROS or Debian, and neither with Python nor from PyPI."""
    spec = importlib.util.find_spec(module)
    return 'dist-packages' in str(spec and spec.origin)


def needs(folder):
    """Return the keys of what a package's Python files and launch files use."""
    # setup.py runs in catkin's own Python.
    sources = [path for path in folder.rglob('*.py')
               if path.name != 'setup.py' and path.parts[-3] != 'nodes']  # these are as learners write
    trees = [ast.parse(source.read_text()) for source in sources]
    modules = {name for tree in trees for name in imports(tree)}
    modules -= {'odometry_tests'}  # it tests all others, so that none can depend on it
    keys = {KEYS.get(module, module) for module in modules if module in KEYS or is_installed(module)}
    for path in [*folder.rglob('*.launch'), *folder.rglob('*.test')]:
        keys |= set(re.findall(r'(?:pkg="|\$\(find )(\w+)', path.read_text()))
    return keys


@pytest.mark.parametrize('manifest', MANIFESTS, ids=lambda path: path.parent.name)
def test_a_package_depends_on_what_it_uses(manifest):
    assert needs(manifest.parent) - depends(manifest) - {name_of(manifest), *OPTIONAL} == set()


def test_an_administrator_installs_what_the_set_up_would():
    """docs/class.md: the line to paste."""
    line, = re.findall(r"apt-get install -y --no-install-recommends ([^']*)", (ROOT / 'docs/class.md').read_text())
    assert {*line.split()} == {*PARTS['DEBIAN'], 'ca-certificates', 'git'}


def debian_packages():
    """Return what Debian calls the dependencies of all packages here."""
    keys = {key for manifest in MANIFESTS for key in depends(manifest)} - {*map(name_of, MANIFESTS)}
    return {package for key in keys for package in DEBIAN.get(
        key, ['python3-' + re.sub('^python3-', '', key).replace('_', '-')])}


def test_a_workspace_of_your_own_gets_what_the_packages_depend_on():
    """docs/workspace.md: neither less nor more than ./ws installs, and what comes with that."""
    page = (ROOT / 'docs/workspace.md').read_text()
    lines = re.findall(r'sudo apt install (?:--no-install-recommends )?([^`\n]*)', page)
    installed = {word for line in lines for word in line.split()}
    by_set_up = {'rviz', *PARTS['DEBIAN'], *PARTS['WINDOW']}
    assert installed == debian_packages() | by_set_up - {'rosout'} | {'git'}
    assert re.search(r'pip install (\S+)', page)[1] in (ROOT / 'requirements.txt').read_text().split()
