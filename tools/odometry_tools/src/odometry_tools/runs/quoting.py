"""Find what to quote in a node's output."""

import re
import signal

# A line counts as Python's error only after a `File` line; a syntax error has no `Traceback`.
TRACEBACK = re.compile(r'^((?:  File ".+", line \d+.*\n(?:    .*\n)*)+)(\w[\w.]*)(?:: (.*))?$',
                       re.MULTILINE)
PLACE = re.compile(r'File "([^"]+)", line (\d+)')
NOT_USER_CODE = re.compile('/usr/|/opt/|dist-packages|site-packages|<frozen|<string>')
# Printed by roslaunch, with the node's name unless that is required, and the exit code.
DIED = re.compile(r'(?:\[(\S+)-\d+\] )?process has died \[pid \S+, exit code (-?\d+)')
SHUTDOWN = 'ROSInterruptException'
MOST = 200  # characters of a quoted line


def error_in(output, place=''):
    """Return the error of the last traceback whose lines contain a place, or ''.

    With the line in the learner's file.
    """
    found = [match for match in _errors_in(output) if place in match[1]]
    if not found:
        return ''
    places, name, words = found[-1].groups()
    lines = [line for path, line in PLACE.findall(places) if not NOT_USER_CODE.search(path)]
    kind = name.rpartition('.')[2]
    error = f'{kind}: {words}' if words else kind
    error = error[:MOST].rstrip(' .')
    return f'{error}, line {lines[-1]}' if lines else error


def _errors_in(output):
    """Return the matches of all tracebacks but those by which rospy ends a wait at shutdown."""
    return [match for match in TRACEBACK.finditer(output) if not match[2].endswith(SHUTDOWN)]


def ends_with_error(output):
    """Return whether an output ends with a traceback."""
    found = _errors_in(output)
    return bool(found) and not output[found[-1].end():].strip()


def last_line(output):
    """Return the last line that is not empty, or ''."""
    lines = [line.strip() for line in output.split('\n') if line.strip()]
    return lines[-1][:MOST] if lines else ''


def listed(names):
    """Return names as a sorted list for a sentence, each once."""
    return ', '.join(sorted(set(names)))


def how_ended(status):
    """Describe an exit status; None: there was no process."""
    if status is None:
        return 'before it started'
    if status < 0:
        return f'by a signal ({signal.strsignal(-status)})'
    return f'with status {status}'
