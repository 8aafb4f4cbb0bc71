"""Write test/unit/wheels.jsonl anew: ./ws python3 test/tools/wheels.py.

It lists, for each version of Python, the wheels that pip chooses from PyPI for the requirements,
so that test_requirements can have pip choose again without a network. This needs Python 3.11.
"""

import argparse
import json
import re
import subprocess
from pathlib import PurePosixPath
from urllib.parse import urlparse

from odometry_tests.other_pythons import PYTHONS, REQUIREMENTS, WHEELS, pip_for

# Of the optional requirements of packages, selenium asks for one.
EXTRA = re.compile('extra == (?!.socks)')
PYBULLET = re.search('^pybullet==.*', REQUIREMENTS[0].read_text(), re.MULTILINE)[0]


def main():
    """Write the table, unless asked for help."""
    argparse.ArgumentParser(description=__doc__.splitlines()[0]).parse_args()
    wheels = {}
    for python in PYTHONS:
        wheels.update(chosen(python, *without_pybullet()))
        wheels.update(chosen(python, PYBULLET))
    names = {name_of(wheel['name']) for wheel in wheels.values()}
    for wheel in wheels.values():
        wheel['requires'] = [line for line in wheel['requires']
                             if name_of(line) in names and not EXTRA.search(line)]
    WHEELS.write_text(''.join(f'{json.dumps(wheels[file])}\n' for file in sorted(wheels)))


def without_pybullet():
    """Return all requirements but PyBullet, which is not there for each Python."""
    lines = [line for file in REQUIREMENTS for line in file.read_text().splitlines()]
    return [line.partition('#')[0].strip() for line in lines
            if line.partition('#')[0].strip() not in ('', PYBULLET)]


def chosen(python, *requirements):
    """Return the wheels that pip chooses, by their files; none if there is no such wheel."""
    choose = pip_for(python, 'install', '--dry-run', '--ignore-installed', '--target', '/nowhere',
                     '--report', '-', *requirements)
    run = subprocess.run(choose, check=False, capture_output=True, text=True)
    if run.returncode:
        print(f'{python}: {run.stderr.strip().splitlines()[-1]}')
        return {}
    return {file_of(item): about(item) for item in json.loads(run.stdout)['install']}


def file_of(item):
    """Return the name of a wheel's file."""
    return PurePosixPath(urlparse(item['download_info']['url']).path).name


def about(item):
    """Return what a resolver asks of a wheel."""
    metadata = item['metadata']
    return {'file': file_of(item), 'name': metadata['name'], 'version': metadata['version'],
            'python': metadata.get('requires_python', ''),
            'requires': metadata.get('requires_dist', [])}


def name_of(requirement):
    """Return the name in a requirement as PyPI compares it."""
    return re.sub('[-_.]+', '-', re.match(r'[\w.-]+', requirement)[0]).lower()


if __name__ == '__main__':
    main()
