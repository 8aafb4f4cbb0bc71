"""A folder of submissions, each judged by a check of its own."""

import concurrent.futures
import csv
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from odometry_common.parameters import StartError

from odometry_tools.check.report import COLUMNS, PASSED

TIME_LIMIT = 300.0  # s of wall time for each
END_LIMIT = 20.0  # s for its processes to end then
AT_ONCE = 2


def judge_all(options):
    """Judge each file and package in a folder; print a line for each, and return their rows."""
    folder = Path(options.node[0])
    submissions = sorted(path for path in folder.iterdir()
                         if path.suffix == '.py' or (path / 'package.xml').is_file())
    if not submissions:
        raise StartError(f'{folder} has no file *.py and no package')
    width = max(len(path.name) for path in submissions)
    rows = []
    with concurrent.futures.ThreadPoolExecutor(min(AT_ONCE, os.cpu_count())) as pool:
        futures = [pool.submit(_judge, options, path) for path in submissions]
        try:
            for path, future in zip(submissions, futures):
                found = future.result()
                failed = [f'{row["scenario"]} {row["rule"]}'.strip()
                          for row in found if row['verdict'] != PASSED]
                print(f'{path.name:{width}}  {len(found) - len(failed)} of {len(found)} passed  '
                      f'{", ".join(failed)}'.rstrip(), flush=True)
                rows += found
        finally:
            for future in futures:
                future.cancel()
    return rows


def _judge(options, path):
    """Return the rows of one submission."""
    try:
        node = path if path.is_file() else _node_of(path)
    except StartError as error:
        return [_not_judged(options, path, error)]
    with tempfile.NamedTemporaryFile('r', suffix='.csv') as file:
        command = [sys.executable, sys.argv[0], options.exercise, str(node), '--csv', file.name,
                   *(['--scenario', options.scenario] if options.scenario else [])]
        paths = os.pathsep.join(filter(None, [str(path / 'src'), os.environ.get('PYTHONPATH')]))
        with subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, text=True, env={**os.environ, 'PYTHONPATH': paths}) as check:
            try:
                _, errors = check.communicate(timeout=TIME_LIMIT)
            except subprocess.TimeoutExpired:
                check.terminate()
                check.communicate(timeout=END_LIMIT)
                return [_not_judged(options, path, f'not done within {TIME_LIMIT:g} s')]
            rows = [{**row, 'submission': path.name} for row in csv.DictReader(file)]
            return rows or [_not_judged(options, path, (errors.strip().splitlines() or ['no verdict'])[-1])]


def _node_of(package):
    """Return the node of a package: its only executable Python file, or its only one."""
    files = [path for path in sorted(package.rglob('*.py')) if path.name not in ('setup.py', '__init__.py')]
    files = [path for path in files if os.access(path, os.X_OK)] or files
    if len(files) != 1:
        raise StartError(f'{len(files)} files could be the node of this package')
    return files[0]


def _not_judged(options, path, reason):
    return {**dict.fromkeys(COLUMNS, ''), 'submission': path.name, 'exercise': options.exercise,
            'verdict': 'not judged', 'rule': 'not_judged', 'sentence': str(reason)}
