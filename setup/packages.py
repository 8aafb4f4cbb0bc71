"""Build each package in .ws/src separately, so that an error in one stops no other.

usage: packages.py depends|build WORKSPACE FOLDER..., where FOLDERs are the packages of this project.
"""

import re
import subprocess
import sys
from pathlib import Path

from catkin_pkg.package import InvalidPackage, parse_package
from catkin_pkg.packages import find_package_paths
from catkin_pkg.topological_order import topological_order_packages

WORKSPACE = Path(sys.argv[2])
# Without PWD, CMake would resolve the links in the path of its folder.
BUILD = 'cd "$1" && . "$0/devel/setup.bash" && { [ -e Makefile ] || cmake "${@:2}"; } && make -k'
ERROR = re.compile(r'CMake Error.*\n\s*((?:.+\n)+)|(\S+: error: .*)')
# Debian's names of a ROS package. Some of its packages have the name of a ROS package: tf is a game.
DEBIAN = r'^(?:lib{0}(?:-config-init-mutex)?-dev|python3-{0}|ros-{0}|{0}-tools|(?=python3-|lib|rviz|topic-|joint-){0})$'
KINDS = 'buildtool_depends', 'build_depends', 'build_export_depends', 'exec_depends', 'test_depends'


def read_packages():
    """Return the valid packages by folder, all names, and a line about each invalid package."""
    packages, errors = {}, []
    taken = {parse_package(folder).name: folder for folder in sys.argv[3:]}
    for path in sorted(find_package_paths(f'{WORKSPACE}/src')):
        folder = f'{WORKSPACE}/src/{path}'
        try:
            package = parse_package(folder, warnings=[])
            if package.name in taken:
                raise InvalidPackage(f'{taken[package.name]} has the name {package.name}, too: rename yours')
        except (InvalidPackage, OSError, ValueError) as error:
            reason = str(error).partition("package.xml':")[2] or error
            errors.append(f'left out .ws/src/{path}: {reason}')
        else:
            package.evaluate_conditions({'ROS_VERSION': '1', 'ROS_PYTHON_VERSION': '3'})
            packages[folder], taken[package.name] = package, folder
    return packages, taken, errors


def build():
    """Build the packages, and write the errors to the file left_out."""
    packages, _, errors = read_packages()
    for folder, package in topological_order_packages(packages):
        if folder is None:
            errors.append(f'left out {package}: they depend on each other')
            continue
        place = WORKSPACE / 'build' / folder[len(f'{WORKSPACE}/'):].replace('/', '+')
        place.mkdir(parents=True, exist_ok=True)
        run = subprocess.run(
            ['bash', '-c', BUILD, WORKSPACE, place, folder, f'-DPYTHON_EXECUTABLE={sys.executable}',
             f'-DCATKIN_DEVEL_PREFIX={WORKSPACE}/devel'], check=False, text=True, errors='replace',
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        print(run.stdout, flush=True)
        if run.returncode:
            error = ERROR.search(run.stdout)
            errors.append(f'{package.name} is not built, or only in part: '
                          f'{error[1] or error[2] if error else f"see {WORKSPACE}/setup.log"}')
    (WORKSPACE / 'devel' / '.catkin').write_text(';'.join([f'{WORKSPACE}/ours', *packages]))
    (WORKSPACE / 'left_out').write_text(''.join(' '.join(error.split()).rstrip(':') + '\n' for error in errors))


def depends():
    """Print the apt packages of all dependencies; standard input has the names that apt knows."""
    known, (packages, taken, _) = sys.stdin.read(), read_packages()
    needed = {depend.name: package.name for package in packages.values() for kind in KINDS
              for depend in getattr(package, kind) if depend.evaluated_condition}
    for name in sorted(needed.keys() - taken.keys() - {'catkin'}):
        names = re.findall(DEBIAN.format(re.escape(name.replace('_', '-'))), known, re.MULTILINE)
        print(*sorted(names))
        if not names and not Path('/usr/share', name, 'package.xml').exists():
            print(f'./ws: {needed[name]} depends on {name}, which apt does not know', file=sys.stderr)


{'depends': depends, 'build': build}[sys.argv[1]]()
