"""Output of a check: the report, files for CI and for a class, and recordings."""

import os
import re
import textwrap

import rosbag

from odometry_tools.check.scenarios import GOAL
from odometry_tools.runs import junit
from odometry_tools.runs.figure import make_figure
from odometry_tools.runs.folders import RUNS
from odometry_tools.runs.output import complain
from odometry_tools.runs.plain_text import plain
from odometry_tools.runs.recorded_run import BagError, read_run
from odometry_tools.runs.recording import ROBOT_TOPICS

WIDTH = 100
COLUMNS = 'submission', 'exercise', 'scenario', 'verdict', 'rule', 'hint', 'sentence', 'notes'


def show(verdicts, folders):
    """Print Verdicts and their recordings' folders (by scenario); each sentence and note once."""
    scenarios, notes = {}, {}
    for verdict in verdicts:
        begin = f'  {verdict.scenario:<12} {verdict.word:<8} '
        earlier = None if verdict.has_passed else scenarios.get(verdict.sentence)
        print(_filled(begin, f'as in {earlier}' if earlier else verdict.sentence))
        scenarios.setdefault(verdict.sentence, verdict.scenario)
        notes = {**verdict.notes, **notes}
        if verdict.scenario in folders:
            print(f'{"":{len(begin)}}{os.path.relpath(folders[verdict.scenario])}')
    for sentence in notes.values():
        print(_filled('  note  ', sentence))


def _filled(begin, sentence):
    return textwrap.fill(sentence, WIDTH, initial_indent=begin, subsequent_indent=' ' * len(begin),
                         break_long_words=False, break_on_hyphens=False)


def rows_of(submission, exercise, verdicts):
    """Return the verdicts as rows of COLUMNS."""
    return [{
        **verdict._asdict(),
        'submission': plain(submission),
        'exercise': exercise,
        'verdict': verdict.word,
        'notes': ' | '.join(verdict.notes.values())} for verdict in verdicts]


def write_junit(path, rows):
    """Write rows as a JUnit file."""
    junit.write(path, 'odometry_check', [junit.Case(
        f'{row["exercise"]}.{row["submission"]}', row['scenario'],
        '' if row['verdict'] == 'passed' else row['sentence'], row['rule'], row['notes'])
        for row in rows])


def keep(run, exercise, name):
    """Write bag, picture and output of a Run to a folder; return its path, or None on failure."""
    folder = RUNS / re.sub(r'[^\w.-]+', '_', name)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        (folder / 'run.png').unlink(missing_ok=True)  # an earlier check's
        (folder / 'output.txt').write_text(run.output, encoding='utf-8')
        with rosbag.Bag(str(folder / 'run.bag'), 'w') as bag:
            for topic, message, time in run.messages:
                bag.write(f'/{topic}', message, time)
        # One topic may lack the last message of the other.
        ends = {topic: message.header.stamp.to_sec()
                for topic, message, _ in run.messages if topic in ROBOT_TOPICS}
        shown = read_run(folder / 'run.bag', end=min(ends.values(), default=0.0))
        figure = make_figure(shown, **_targets(exercise))
        figure.savefig(str(folder / 'run.png'))
    except BagError:
        pass  # no odometry: there is nothing to draw
    except OSError as error:
        complain(f'no recording: {error}')
        return None
    return folder


def _targets(exercise):
    """Return the target that the picture shows, as keywords."""
    if exercise.route:
        return {}
    if exercise.target is None:
        return {'distance_target': GOAL}
    return {'heading_target': exercise.target}
