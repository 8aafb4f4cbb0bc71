"""A folder of submissions, each judged by a check of its own."""

import csv
import sys
import tempfile
import time
from pathlib import Path

from odometry_common.parameters import StartError

from odometry_tools.check.options import is_package
from odometry_tools.check.processes import LOOK_PERIOD, ChildProcess
from odometry_tools.check.quoting import how_ended, last_line, plain
from odometry_tools.check.report import COLUMNS

TIME_LIMIT = 300.0  # s of wall time for each


def judge_all(options):
    """Judge each file and package in a folder; print a line for each, and yield their rows."""
    folder = Path(options.node[0])
    submissions = sorted(path for path in folder.iterdir()
                         if path.suffix == '.py' or is_package(path))
    if not submissions:
        raise StartError(f'{folder} has no file *.py and no package')
    width = max(len(plain(path.name)) for path in submissions)
    for path in submissions:
        rows = _judge(options, path)
        failed = [f'{row["scenario"]} {row["rule"]}'.strip() for row in rows
                  if row['verdict'] != 'passed']
        print(f'{plain(path.name):{width}}  {len(rows) - len(failed)} of {len(rows)} passed  '
              f'{", ".join(failed)}'.rstrip(), flush=True)
        yield rows


def _judge(options, path):
    """Return the rows of one submission. It cannot end another, and leaves nothing running."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, 'rows.csv')
        scenario_option = ['--scenario', options.scenario] if options.scenario else []
        check = ChildProcess([sys.executable, sys.argv[0], options.exercise, str(path),
                              '--csv', str(file), *scenario_option], [('TMPDIR', folder)])
        end = time.monotonic() + TIME_LIMIT
        try:
            while check.status is None and time.monotonic() < end:
                time.sleep(LOOK_PERIOD)
            status = check.status
        finally:
            check.end()  # and all that it has left
        rows = []
        if file.exists():
            with file.open(encoding='utf-8', newline='') as table:
                rows = [{**row, 'submission': plain(path.name)} for row in csv.DictReader(table)]
    if rows:
        return rows
    reason = f'not done within {TIME_LIMIT:g} s'
    if status is not None:
        reason = (f'the check ended {how_ended(status)}' if status < 0
                  else last_line(plain(check.output)))
    return [{**dict.fromkeys(COLUMNS, ''), 'submission': plain(path.name),
             'exercise': options.exercise, 'verdict': 'not judged', 'rule': 'not_judged',
             'sentence': reason}]
