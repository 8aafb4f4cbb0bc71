"""What a node printed, as a report may quote it: always the same, without control characters."""

import re
import signal

# Colours and other commands to a terminal; log stamps; addresses, ports and numbers of processes.
CHANGING = [(re.compile(pattern), by) for pattern, by in (
    (r'\x1b\][^\x07\x1b]*(?:\x07|\x1b\\)?|\x1b\[[0-?]*[ -/]*[@-~]|\x1b.?', ''),
    (r'[\x00-\x08\x0b-\x1f\x7f-\x9f\ud800-\udfff\ufffe\uffff]', ''),
    (r'(\[ *\w+\] )?\[\d+\.\d+(, \d+\.\d+)?\]: ', ''),
    (r'0x[0-9a-fA-F]+', '0x...'),
    (r'(localhost|\d+\.\d+\.\d+\.\d+):\d+', r'\1:...'),
    (r'\b(pid|process) \d+', r'\1 ...'))]
# Without `Traceback` and `File` a line is none of Python's; a syntax error has `File` only.
TRACEBACK = re.compile(r'^((?:  File ".+", line \d+.*\n(?:    .*\n)*)+)(\w[\w.]*)(?:: (.*))?$',
                       re.MULTILINE)
PLACE = re.compile(r'File "([^"]+)", line (\d+)')
NOT_USER_CODE = re.compile('/usr/|/opt/|dist-packages|site-packages|<frozen|<string>')
DIED = re.compile(r'process has died \[pid \S+, exit code (-?\d+)')  # roslaunch's words
MOST = 200  # characters of a line


def plain(text):
    """Return a text without what differs each time or is meant for a terminal."""
    for pattern, by in CHANGING:
        text = pattern.sub(by, text)
    return text


def error_in(output):
    """Return the error of the last traceback and the line of the learner's file, or ''."""
    found = [*TRACEBACK.finditer(output)]
    if not found:
        return ''
    places, name, words = found[-1].groups()
    lines = [line for path, line in PLACE.findall(places) if not NOT_USER_CODE.search(path)]
    kind = name.rpartition('.')[2]
    error = f'{kind}: {words}' if words else kind
    error = error[:MOST].rstrip(' .')
    return f'{error}, line {lines[-1]}' if lines else error


def ends_with_error(output):
    """Return whether an output ends with a traceback."""
    found = [*TRACEBACK.finditer(output)]
    return bool(found) and not output[found[-1].end():].strip()


def last_line(output):
    """Return the last line that is not empty, or ''."""
    lines = [line.strip() for line in output.split('\n') if line.strip()]
    return lines[-1][:MOST] if lines else ''


def listed(names):
    """Return names for a sentence: each once, in order."""
    return ', '.join(sorted(set(names)))


def how_ended(status):
    """Describe an exit status."""
    if status < 0:
        return f'by a signal ({signal.strsignal(-status)})'
    return f'with status {status}'
