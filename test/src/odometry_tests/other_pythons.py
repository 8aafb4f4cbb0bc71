"""What pip would install for a Python that is not here."""

import sys

from odometry_tests.scripts import ROOT

# The numpy of the system that has it, if it serves: Ubuntu 20.04, none, Ubuntu 22.04, Debian 12,
# Ubuntu 24.04, Debian 13.
SYSTEM_NUMPY = {'3.8': None, '3.9': None, '3.10': '1.21.5', '3.11': '1.24.2', '3.12': '1.26.4',
                '3.13': '2.2.4'}
PYTHONS = list(SYSTEM_NUMPY)
REQUIREMENTS = [ROOT / name for name in (
    'requirements.txt', 'robot_view/requirements.txt', 'odometry_sweep/requirements.txt',
    'odometry_sweep/requirements-cluster.txt', 'test/requirements.txt')]
WHEELS = ROOT / 'test' / 'unit' / 'wheels.jsonl'  # test/tools/wheels.py makes it
# pip decides by --python-version which wheels fit, but of python_version, and whether a wheel may be
# installed, it asks its own Python.
PIP = """
import sys
from pip._internal.cli.main import main
from pip._internal.resolution.resolvelib.candidates import RequiresPythonCandidate
from pip._vendor.packaging import markers
version, usual = sys.argv.pop(1), markers.default_environment
markers.default_environment = lambda: {
    **usual(), 'python_version': version, 'python_full_version': version + '.0'}
init = RequiresPythonCandidate.__init__
RequiresPythonCandidate.__init__ = lambda self, _: init(self, tuple(map(int, version.split('.'))))
sys.exit(main())
"""


def pip_for(python, command, *arguments):
    """Return the command that has pip choose wheels for a version of Python, such as '3.8'."""
    return [sys.executable, '-c', PIP, python, command, '--disable-pip-version-check', '--quiet',
            '--no-cache-dir', '--only-binary', ':all:', '--python-version', python,
            *map(str, arguments)]
