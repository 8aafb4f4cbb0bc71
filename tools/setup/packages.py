"""Build each package in .ws/src separately, so that an error in one stops no other.

usage: packages.py depends|build WORKSPACE SOURCES FOLDER...

SOURCES is a regular expression: the names of the files that are compiled or configure that. FOLDERs
are the packages of this project.
"""

import hashlib
import os
import re
import shutil
import signal
import subprocess
import sys
from pathlib import Path

# Ctrl-C prints no traceback, during the next imports neither.
signal.signal(signal.SIGINT, signal.SIG_DFL)

import yaml
from catkin_pkg.topological_order import topological_order_packages
from manifests import names_of_depends, read_packages

WORKSPACE, SOURCES, OURS = Path(sys.argv[2]), re.compile(sys.argv[3]), sys.argv[4:]
DEVEL = WORKSPACE / 'devel'
LONGEST_NAME = 200  # bytes
MODULES = 'devel/lib/python3/dist-packages'
# Without PWD, CMake would resolve the links in the path of its folder. Without a build type it
# would not optimise: gmapping, amcl and move_base then take several times as long.
BUILD = ('cd "$1" && . "$0/devel/setup.bash" && '
         'cmake -G "Unix Makefiles" -DCMAKE_BUILD_TYPE=Release "${@:2}" && make -k -j"$(nproc)"')
# The folders of a package's own devel space are linked into the common one, set-up files are not.
LINK = 'shopt -s nullglob; for folder in "$0"/devel/*/; do cp -rsf "$folder" "$1" || exit; done'
ERROR = re.compile(
    r'CMake Error.*\n\s*((?:.+\n)+)'
    r'|(\S+: (?:fatal )?error: .*'
    r'|.*\bld: .*(?:undefined reference|cannot find).*)')


def build():
    """Build what has changed, from nothing, and write the errors to the file left_out."""
    packages, checksums, _, errors = read_packages(WORKSPACE, SOURCES, OURS)
    places = {folder: WORKSPACE / 'build' / _name_of(folder) for folder in packages}
    for place in {*(WORKSPACE / 'build').glob('src*')} - {*places.values()}:
        shutil.rmtree(place)
    keys, failed = {}, set()
    for folder, package in topological_order_packages(packages):
        if folder is None:
            errors.append(f'left out {package}: they depend on each other')
            continue
        depends = sorted(names_of_depends(package))
        keys[package.name] = checksums[folder] + ''.join(
            hashlib.sha256(keys[name].encode()).hexdigest() for name in depends if name in keys)
        place = places[folder]
        error = build_package(folder, place, keys[package.name])
        if module := module_of_ours(place):
            error = f'its Python module {module} is one of ours, too: rename it'
        elif subprocess.run(['bash', '-c', LINK, place, DEVEL], check=False).returncode:
            error = error or f'see {WORKSPACE}/setup.log'
        if error:
            missing = ', '.join(name for name in depends if name in failed)
            reason = f'it depends on {missing}' if missing else error
            errors.append(f'{package.name} is not built, or only in part: {reason}')
            failed.add(package.name)
    subprocess.run(['find', DEVEL, '-xtype', 'l', '-delete'], check=True)  # links to what is gone
    (DEVEL / '.catkin').write_text(';'.join([f'{WORKSPACE}/ours', *packages]))
    lines = [' '.join(error.split()).rstrip(':') + '\n' for error in errors]
    (WORKSPACE / 'left_out').write_text(''.join(lines), errors='replace')


def _name_of(folder):
    """Return a name for the build folder of a package; Linux allows 255 bytes."""
    path = str(Path(folder).relative_to(WORKSPACE))
    encoded = os.fsencode(path)
    if len(encoded) > LONGEST_NAME or '+' in path:
        return f'src+{hashlib.sha256(encoded).hexdigest()}'
    return path.replace('/', '+')


def build_package(folder, place, key):
    """Build a package, unless that has been done with this key, and return an error or None."""
    built = place / 'built'
    if built.exists() and built.read_text() == key:
        return None
    shutil.rmtree(place, ignore_errors=True)
    place.mkdir(parents=True)
    run = subprocess.run(
        ['bash', '-c', BUILD, WORKSPACE, place, folder, f'-DPYTHON_EXECUTABLE={sys.executable}',
         f'-DCATKIN_DEVEL_PREFIX={place}/devel'], check=False, text=True, errors='replace',
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    print(run.stdout, flush=True)
    if not run.returncode:
        built.write_text(key)
        return None
    error = ERROR.search(run.stdout)
    if not error:
        return f'see {WORKSPACE}/setup.log'
    return error[1] or error[2]


def module_of_ours(place):
    """Return the name of a Python module that ours have and a package has built, too, or None."""
    modules = Path(place, MODULES)
    for path in modules.rglob('*.py'):
        twin = DEVEL.parent / MODULES / path.relative_to(modules)
        if twin.exists() and not twin.is_symlink():  # the links are to the user's packages
            return path.relative_to(modules).parts[0]
    return None


def depends():
    """Print Debian's packages for all dependencies; standard input has the names that apt knows.

    A name that rosdep's table lacks, such as Debian's own, is only reported.
    """
    known = {*sys.stdin.read().split()}
    packages, _, taken, _ = read_packages(WORKSPACE, SOURCES, OURS)
    table = yaml.safe_load(Path(__file__).with_name('rosdep.yaml').read_text())
    needed = {}
    for folder, package in packages.items():
        needed.update(dict.fromkeys(names_of_depends(package), package.name))
        lists = Path(folder, 'CMakeLists.txt')
        # catkin_create_pkg mentions it in a comment.
        if lists.is_file() and 'gtest' in re.sub('#.*', '', lists.read_text(errors='replace')):
            needed['gtest'] = 'catkin'  # its catkin_add_gtest() has no effect without that
    for name in sorted(needed.keys() - taken.keys() - {'catkin'}):
        parts = known.intersection(table.get(name, ()))
        print(*sorted(parts))
        if (not parts and not Path('/usr/share', name, 'package.xml').exists()
                and not is_installed(name)):
            reason = 'which apt does not know'
            if name in known:
                reason = f"which is Debian's, not ROS's: sudo apt-get install --no-remove {name}"
            print(f'./ws: {needed[name]} depends on {name}, {reason}', file=sys.stderr)


def is_installed(name):
    """Return whether Debian's package of this name is installed."""
    query = subprocess.run(
        ['dpkg-query', '-W', '-f', '${db:Status-Status}\n', '--', name],
        check=False, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    return 'installed' in query.stdout.split()


{'depends': depends, 'build': build}[sys.argv[1]]()
