"""What a check leaves: lines on the screen, files for CI and for a class, and the recording of a failure."""

import csv
import os
import textwrap

import rosbag

from odometry_tools.check.judging import PASSED
from odometry_tools.check.scenarios import GOAL
from odometry_tools.runs import junit
from odometry_tools.runs.figure import make_figure
from odometry_tools.runs.folders import new_folder
from odometry_tools.runs.recorded_run import BagError, read_run

WIDTH = 100
COLUMNS = 'submission', 'exercise', 'scenario', 'verdict', 'rule', 'sentence', 'notes'


def show(verdict, folder, earlier):
    """Print a Verdict, after earlier ones, and where its recording is, if there is one."""
    begin = f'  {verdict.scenario:<12} {verdict.word:<8} '
    same = [other.scenario for other in earlier if folder and other.sentence == verdict.sentence]
    print(_filled(begin, f'as in {same[0]}' if same else verdict.sentence))
    if folder:
        print(f'{"":{len(begin)}}{os.path.relpath(folder)}', flush=True)


def show_notes(verdicts):
    """Print each note once."""
    notes = {}
    for verdict in verdicts:
        notes = {**verdict.notes, **notes}
    for sentence in notes.values():
        print(_filled('  note  ', sentence), flush=True)


def _filled(begin, sentence):
    return textwrap.fill(sentence, WIDTH, initial_indent=begin, subsequent_indent=' ' * len(begin),
                         break_long_words=False, break_on_hyphens=False)


def rows_of(submission, exercise, verdicts):
    """Return the verdicts as rows of COLUMNS."""
    return [dict(zip(COLUMNS, (submission, exercise, verdict.scenario, verdict.word, verdict.rule,
                               verdict.sentence, ' | '.join(verdict.notes.values()))))
            for verdict in verdicts]


def write_csv(path, rows):
    """Write rows for a spreadsheet."""
    with open(path, 'w', newline='', encoding='utf-8') as file:
        writer = csv.DictWriter(file, COLUMNS)
        writer.writeheader()
        writer.writerows(rows)


def write_junit(path, rows):
    """Write rows as CI reads them."""
    junit.write(path, 'odometry_check', [junit.Case(
        f'{row["exercise"]}.{row["submission"]}', row['scenario'],
        '' if row['verdict'] == PASSED else row['sentence'], row['rule'], row['notes']) for row in rows])


def keep(run, target):
    """Write bag, picture and output of a Run to a new folder, and return that."""
    folder = new_folder(f'check-{run.scenario.name}-')
    (folder / 'output.txt').write_text(run.output)
    with rosbag.Bag(str(folder / 'run.bag'), 'w') as bag:
        for topic, message, time in run.messages:
            bag.write(f'/{topic}', message, time)
    targets = {'distance_target': GOAL} if target is None else {'heading_target': target}
    try:
        make_figure(read_run(folder / 'run.bag'), **targets).savefig(str(folder / 'run.png'))
    except BagError:
        pass  # the robot's time has not begun
    return folder
