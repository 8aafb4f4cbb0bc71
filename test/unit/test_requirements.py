"""The requirements files for each Python: what pip would choose, from a table of PyPI's wheels."""

import json
import platform
import re
import shlex
import subprocess
import zipfile

import pytest
from odometry_tests.other_pythons import PYTHONS, REQUIREMENTS, SYSTEM_NUMPY, WHEELS, pip_for
from odometry_tests.scripts import ROOT

BASE = REQUIREMENTS[0]
PYBULLET = re.search('^pybullet==(.*)', BASE.read_text(), re.MULTILINE)[1]
NAMED = re.compile(r'^([\w.-]+)==', re.MULTILINE)
SET_UP = shlex.quote(str(ROOT / 'setup'))
HAS_WHEEL = f"""
. {SET_UP}/python.bash
python_version() {{ echo "$PYTHON_VERSION"; }}
uname() {{ echo "$MACHINE"; }}
pybullet() {{ echo pybullet==0; }}
wheels() {{ echo /nowhere; }}
has_pybullet
"""


def make_wheel(folder, file, name, version, python='', requires=()):
    """Make a wheel without anything in it but what pip asks of it."""
    about = f'{file.split("-")[0]}-{version}.dist-info'
    metadata = [f'Metadata-Version: 2.1\nName: {name}\nVersion: {version}']
    metadata += [f'Requires-Python: {python}'] * bool(python)
    metadata += [f'Requires-Dist: {line}' for line in requires]
    extras = {extra for line in requires for extra in re.findall(r"extra == ['\"](.*?)['\"]", line)}
    metadata += [f'Provides-Extra: {extra}' for extra in sorted(extras)]
    with zipfile.ZipFile(folder / file, 'w') as wheel:
        wheel.writestr(f'{about}/METADATA', '\n'.join(metadata) + '\n')
        wheel.writestr(f'{about}/WHEEL', 'Wheel-Version: 1.0\n')
        wheel.writestr(f'{about}/RECORD', '')


@pytest.fixture(scope='module')
def wheels(tmp_path_factory):
    """Make the wheels of the table, the numpy of each system, and PyBullet as ./ws compiles it."""
    if platform.machine() != 'x86_64':
        pytest.skip('the table is of wheels for x86-64, and pip takes those of its own processor')
    folder = tmp_path_factory.mktemp('wheels')
    for line in WHEELS.read_text().splitlines():
        make_wheel(folder, **json.loads(line))
    for version in filter(None, SYSTEM_NUMPY.values()):
        make_wheel(folder, f'numpy-{version}-py3-none-any.whl', 'numpy', version)
    compiled = tmp_path_factory.mktemp('compiled')
    make_wheel(compiled, f'pybullet-{PYBULLET}-py3-none-any.whl', 'pybullet', PYBULLET)
    return folder, compiled


@pytest.fixture
def choose(wheels, tmp_path):
    """Return a function that has pip choose for a Python, and returns the versions by name."""
    def choose_for(python, *arguments):
        folders = [word for folder in wheels for word in ('--find-links', folder)]
        command = pip_for(python, 'download', '--no-index', *folders, '--dest', tmp_path)
        command += map(str, arguments)
        run = subprocess.run(command, check=False, capture_output=True, text=True)
        assert run.returncode == 0, run.stderr
        files = [file.name.split('-') for file in tmp_path.iterdir()]
        return {name.lower().replace('_', '-'): version for name, version, *_ in files}
    return choose_for


@pytest.mark.parametrize('python', PYTHONS)
def test_the_requirements_can_be_installed(python, choose):
    """All of them at once, since they share an environment."""
    files = [word for file in REQUIREMENTS for word in ('-r', file)]
    found = choose(python, *files)
    named = {name.lower() for file in REQUIREMENTS for name in NAMED.findall(file.read_text())}
    assert named <= set(found), found


@pytest.mark.parametrize('python', [python for python in PYTHONS if SYSTEM_NUMPY[python]])
def test_the_base_takes_the_numpy_of_the_system(python, choose):
    """A second one would make each start slower."""
    numpy = SYSTEM_NUMPY[python]
    assert choose(python, '-r', BASE, f'numpy=={numpy}')['numpy'] == numpy


@pytest.mark.parametrize('python', PYTHONS)
def test_pybullet_is_compiled_where_there_is_no_wheel(python, wheels):
    """./ws decides it without asking PyPI, so that it can say at once what it costs."""
    wheel = f'pybullet-{PYBULLET}-cp{python.replace(".", "")}-*_x86_64.whl'
    assert says_has_wheel(python, 'x86_64') == bool(list(wheels[0].glob(wheel)))
    assert not says_has_wheel(python, 'aarch64')


def says_has_wheel(python, machine):
    """Return what ./ws believes of a Python and a processor."""
    variables = {'PATH': '/usr/bin:/bin', 'PYTHON_VERSION': python, 'MACHINE': machine}
    return subprocess.run(['bash', '-c', HAS_WHEEL], env=variables,
                          check=False).returncode == 0
