"""Find and read the packages in the user's workspace."""

import hashlib
import os
from pathlib import Path

from catkin_pkg.package import InvalidPackage, parse_package

IGNORED = {'AMENT_IGNORE', 'CATKIN_IGNORE', 'COLCON_IGNORE'}
KINDS = 'buildtool_depends', 'build_depends', 'build_export_depends', 'exec_depends', 'test_depends'


def walk(top):
    """Yield each folder once with the names in it, even if links form circles."""
    seen = set()
    for folder, folders, files in os.walk(top, followlinks=True):
        real = os.path.realpath(folder)
        if real in seen:
            folders.clear()
        else:
            seen.add(real)
            folders[:] = sorted(name for name in folders if not name.startswith('.'))
            yield folder, folders, files


def find_packages(top):
    """Yield the folders of packages in a folder."""
    for folder, folders, files in walk(top):
        if IGNORED.intersection([*folders, *files]):
            folders.clear()
        elif 'package.xml' in files:
            folders.clear()
            yield folder


def checksum(folder, sources):
    """Return a checksum of a package: its sources, and the names of its scripts.

    :param sources: regular expression of their names
    """
    total = hashlib.sha256()
    for place, _, files in walk(folder):
        for name in sorted(files):
            path = os.path.join(place, name)
            if sources.fullmatch(name) and os.path.isfile(path):  # not Emacs's lock, a broken link
                total.update(os.fsencode(path) + b'\0' + Path(path).read_bytes())
            elif name.endswith('.py'):
                total.update(os.fsencode(path) + b'\0')
    return total.hexdigest()


def is_utf8(path):
    """Return whether a path is UTF-8; other bytes of it are surrogates in Python."""
    return os.fsencode(path).decode(errors='replace') == path


def names_of_depends(package):
    """Return the names of a package's dependencies whose conditions hold."""
    return {depend.name for kind in KINDS for depend in getattr(package, kind)
            if depend.evaluated_condition}


def read_packages(workspace, sources, ours):
    """Return valid packages and checksums by folder, all names, and a line for each left out.

    :param workspace: its folder, a Path
    :param sources: as for checksum()
    :param ours: folders of this project's packages
    """
    packages, checksums, errors = {}, {}, []
    taken = {parse_package(folder).name: folder for folder in ours}
    for folder in find_packages(workspace / 'src'):
        try:
            if not is_utf8(folder):
                raise InvalidPackage('its path is not UTF-8, and catkin reads no other')
            package = parse_package(folder, warnings=[])
            if package.name in taken:
                raise InvalidPackage(
                    f'{taken[package.name]} has the name {package.name}, too: rename yours')
            package.evaluate_conditions({'ROS_VERSION': '1', 'ROS_PYTHON_VERSION': '3'})
            checksums[folder] = checksum(folder, sources)
        except Exception as error:  # noqa: BLE001
            reason = str(error).partition("package.xml':")[2] or error
            errors.append(f'left out {os.path.relpath(folder, workspace.parent)}: {reason}')
        else:
            packages[folder], taken[package.name] = package, folder
    return packages, checksums, taken, errors
