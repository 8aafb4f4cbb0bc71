"""Check in a separate process whether PyBullet can load a world file.

Some files make PyBullet end the whole process: a URDF with two root links, or a mesh that is a
folder. With a mesh that is a pipe it hangs. Run as a script, this file is that process.
"""

import functools
import re
import signal
import subprocess
import sys
import xml.etree.ElementTree
from pathlib import Path

SUFFIXES = '.urdf', '.sdf', '.world'
REMARK = re.compile(r'b3(?:Warning|Error)\[[^\]]*\]:\n')
NO_INERTIA = 'No inertial data for link,'  # PyBullet names the link in another remark
# The simulator has a floor, and rays need no light.
NEEDED_BY_NOBODY = 'model://ground_plane', 'model://sun'
LONGEST_REASON = 300  # characters
LONGEST_LOAD = 30  # s; the largest worlds take a few


class WorldFileError(ValueError):
    """A world file that cannot be used; the message says in one line what it must be."""


@functools.lru_cache(maxsize=None)  # a sweep builds many simulations from one file
def check_world_file(path):
    """Raise WorldFileError if PyBullet cannot load the file."""
    if Path(path).suffix not in SUFFIXES:
        raise WorldFileError('the name of a .urdf or .sdf file')
    if not Path(path).is_file():
        what = 'is a folder' if Path(path).is_dir() else 'there is none'
        raise WorldFileError(f'a file that can be loaded ({what})')
    # In a separate session, Ctrl-C does not make it fail.
    trial = subprocess.run([sys.executable, __file__, path, str(LONGEST_LOAD)], capture_output=True,
                           text=True, errors='replace', start_new_session=True, check=False)
    if trial.returncode:
        raise WorldFileError(f'a file that can be loaded ({_reason(trial)})')


def left_out(path):
    """Return a line about models that a world file includes, which PyBullet ignores; or ''."""
    try:
        includes = xml.etree.ElementTree.parse(path).iter('include')
    # PyBullet finds and reads more files, and in more encodings, than this.
    except (OSError, ValueError, LookupError, xml.etree.ElementTree.ParseError):
        return ''
    uris = {include.findtext('uri', '').strip() for include in includes}
    models = sorted(uri for uri in uris if uri.rstrip('/') not in NEEDED_BY_NOBODY)
    return (f'{path} includes {", ".join(models)}, which PyBullet does not load: '
            'replace each <include> with the <model> of its model.sdf') if models else ''


def load(client, path):
    """Load a URDF or SDF file into a PyBullet client."""
    if Path(path).suffix == '.urdf':
        client.loadURDF(path, useFixedBase=True)
    else:
        client.loadSDF(path)


def _reason(trial):
    """Return in one line what PyBullet printed about a file before it gave up."""
    remarks = REMARK.split(trial.stdout)
    told = [remark for before, remark in zip(remarks, remarks[1:])
            if not before.startswith(NO_INERTIA) and not remark.startswith(NO_INERTIA)]
    if trial.returncode == -signal.SIGALRM:
        return f'not within {LONGEST_LOAD} s'
    if trial.returncode < 0:
        told.insert(0, f'PyBullet ends by {signal.Signals(-trial.returncode).name};')
    told = told or trial.stderr.splitlines()[-1:]
    return ' '.join(' '.join(told).split())[:LONGEST_REASON]


def _main():
    import pybullet
    from pybullet_utils.bullet_client import BulletClient
    client = BulletClient(pybullet.DIRECT)
    signal.alarm(int(sys.argv[2]))
    try:
        load(client, sys.argv[1])
    except pybullet.error as error:
        sys.exit(str(error))


if __name__ == '__main__':
    _main()
