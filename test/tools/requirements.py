"""Ask pip whether each supported Python can install the requirements: ./ws python3 test/tools/requirements.py.

Run it after a change of a version. It needs the network, Python 3.11 and some minutes.
"""

import argparse
import subprocess
import sys

from odometry_tests.scripts import ROOT

BASE = ROOT / 'requirements.txt'
FILES = [BASE, *sorted(ROOT.glob('*/requirements*.txt'))]
# With the numpy of the system that has it, if it serves: Ubuntu 20.04, none, Ubuntu 22.04, Debian 12,
# Ubuntu 24.04, Debian 13. A second one beside it would slow each start.
SYSTEM_NUMPY = {'3.8': None, '3.9': None, '3.10': '1.21.5', '3.11': '1.24.2', '3.12': '1.26.4',
                '3.13': '2.2.4'}
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


def main():
    argparse.ArgumentParser(description=__doc__.splitlines()[0]).parse_args()
    found = [can_install(*version) for version in SYSTEM_NUMPY.items()]
    sys.exit(0 if all(found) else 1)


def can_install(python, numpy):
    """Return whether pip finds a wheel of each requirement but PyBullet, which ./ws can compile."""
    lines = [line.partition('#')[0].strip() for file in FILES for line in file.read_text().splitlines()]
    wanted = [line for line in lines if line and not line.startswith('pybullet==')]
    wanted += [f'numpy=={numpy}'] if numpy else []
    run = subprocess.run(
        [sys.executable, '-c', PIP, python, 'install', '--quiet', '--dry-run', '--ignore-installed',
         '--only-binary', ':all:', '--target', '/nowhere', '--python-version', python, *wanted],
        check=False, capture_output=True, text=True)
    print(f'{python}: {"ok" if run.returncode == 0 else run.stderr.strip()}', flush=True)
    return run.returncode == 0


if __name__ == '__main__':
    main()
