"""Outputs that differ in their numbers only."""

import csv
import re

ESCAPE = re.compile(r'\x1b\[[?\d;]*[A-Za-z]|\x1b\][^\x07]*\x07')
FORMS = [
    (re.compile(r'\[=* *\]'), '[bar]'),
    (re.compile(r'(\d+ days?, )?\d+:\d\d:\d\d'), 'TIME'),
    (re.compile(r' +MISSED$'), ''),  # is said of a number
    (re.compile(r'(?<=_\d\d-\d\d-\d\d)_\d+(?=/)'), ''),  # of a second in which others began too
    (re.compile(r'\S+/(?=runs/)'), ''),  # the tests have it elsewhere
    (re.compile(r'-?\d+(\.\d+)?(e[-+]?\d+)?'), '#'),
    (re.compile(r'(?<=\S) +'), ' '),
]


def plain_lines(output):
    """Return the lines of a terminal's output without its colours, each of a live line's too."""
    return [line.rstrip() for line in re.split(r'[\r\n]+', ESCAPE.sub('', output))]


def number_after(text, output):
    found = re.search(rf'{text} +(-?[0-9.]+)', output)
    assert found, f'no {text!r} in:\n{output}'
    return float(found[1])


def rows_of(path):
    """Return the rows of a CSV file, each a dictionary by column."""
    with path.open(newline='', encoding='utf-8') as file:
        return list(csv.DictReader(file))


def form(line):
    """Return a line with a sign in place of each number."""
    for pattern, replacement in FORMS:
        line = pattern.sub(replacement, line)
    return line.rstrip()


def first_missing(shown, printed):
    """Return the first of the shown lines that is not printed, in form and in this order."""
    forms = iter([form(line) for line in printed])
    return next((line for line in shown if form(line) not in forms), None)
