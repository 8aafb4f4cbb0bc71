"""Judge a folder of submissions, each in a check process of its own, one on each processor."""

import concurrent.futures
import csv
import os
import sys
import tempfile
import threading
import time
from functools import partial
from pathlib import Path

from odometry_common.parameters import StartError

from odometry_tools.check.options import is_package
from odometry_tools.check.processes import POLL_PERIOD, ChildProcess
from odometry_tools.check.report import COLUMNS
from odometry_tools.runs.output import complain
from odometry_tools.runs.plain_text import plain
from odometry_tools.runs.quoting import how_ended, last_line

TIME_LIMIT = 600.0  # s of wall time for each
NOT_JUDGED = 'not_judged'
# Second attempts come one at a time: one submission may have killed the simulators of all.
retry_lock = threading.Lock()


def judge_all(options):
    """Judge each submission in a folder; print a line and yield the rows of each."""
    folder = Path(options.node[0])
    submissions = {plain(str(path.relative_to(folder))): path for path in _submissions_in(folder)}
    if not submissions:
        raise StartError(f'{folder} has no file *.py and no package')
    others = [plain(path.name) for path in sorted(folder.iterdir())
              if path.is_file() and path.suffix != '.py' and not path.name.startswith('.')]
    if others:
        complain(f'no file *.py, and left out: {", ".join(others)}')
    width = max(map(len, submissions))
    judged = _judge_in_parallel(options, submissions)
    for name, rows in zip(submissions, judged):
        failed = [f'{row["scenario"]} {row["rule"]}'.strip() for row in rows
                  if row['verdict'] != 'passed']
        print(f'{name:{width}}  {len(rows) - len(failed)} of {len(rows)} passed  '
              f'{", ".join(failed)}'.rstrip(), flush=True)
        yield rows


def _judge_in_parallel(options, submissions):
    """Yield the rows of each submission, in their order."""
    processors, is_over = os.sched_getaffinity(0), threading.Event()

    def keep_to_one_processor():
        os.sched_setaffinity(0, {processors.pop()})  # of this thread, and of what it starts

    with concurrent.futures.ThreadPoolExecutor(
            len(processors), initializer=keep_to_one_processor) as pool:
        try:
            yield from pool.map(partial(_judge, options, is_over),
                                submissions.values(), submissions)
        finally:
            is_over.set()


def _submissions_in(folder):
    """Return the paths of files and packages in a folder and its subfolders.

    A subfolder without a submission is returned itself, so that its student gets a row.
    """
    found = []
    for path in sorted(folder.iterdir()):
        if path.name.startswith(('.', '__')):  # __MACOSX, __pycache__
            continue
        if path.suffix == '.py' or is_package(path):
            found.append(path)
        elif path.is_dir():
            found += _submissions_in(path) or [path]
    return found


def _judge(options, is_over, path, name):
    """Judge one submission, until an Event, and once more if its check fails; return its rows."""
    end = time.monotonic() + TIME_LIMIT

    def is_in_time():
        return time.monotonic() < end and not is_over.is_set()

    rows = _run_check(options, is_in_time, path, name)
    if rows[0]['rule'] == NOT_JUDGED:
        with retry_lock:
            if is_in_time():
                rows = _run_check(options, is_in_time, path, name)
    return rows


def _run_check(options, is_in_time, path, name):
    """Judge one submission in a process of its own, while a function says that it is in time."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, 'rows.csv')
        scenario_option = ['--scenario', options.scenario] if options.scenario else []
        check = ChildProcess([sys.executable, sys.argv[0], options.exercise, str(path),
                              '--csv', str(file), *scenario_option], [('TMPDIR', folder)])
        while check.status is None and is_in_time():
            time.sleep(POLL_PERIOD)
        status = check.status
        check.end()  # with all of its descendants
        rows = []
        if file.exists():
            with file.open(encoding='utf-8', newline='') as table:
                rows = [{**row, 'submission': name} for row in csv.DictReader(table)]
    if rows:
        return rows
    reason = f'not done within {TIME_LIMIT:g} s'
    if status is not None:
        reason = (f'the check ended {how_ended(status)}' if status < 0
                  else last_line(plain(check.output)))
    return [{**dict.fromkeys(COLUMNS, ''), 'submission': name, 'exercise': options.exercise,
             'verdict': 'not judged', 'rule': NOT_JUDGED, 'sentence': reason}]
