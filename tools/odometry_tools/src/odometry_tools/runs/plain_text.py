"""Text without control characters, and without what differs from run to run."""

import re

# Terminal escapes and control characters; log stamps; addresses, ports and process ids.
CHANGING = [(re.compile(pattern), by) for pattern, by in (
    (r'\x1b\][^\x07\x1b]*(?:\x07|\x1b\\)?|\x1b\[[0-?]*[ -/]*[@-~]|\x1b.?', ''),
    (r'[\x00-\x08\x0b-\x1f\x7f-\x9f\ud800-\udfff\ufffe\uffff]', ''),
    (r'(\[ *\w+\] )?\[\d+\.\d+(, \d+\.\d+)?\]: ', ''),
    (r'0x[0-9a-fA-F]+', '0x...'),
    (r'(localhost|\d+\.\d+\.\d+\.\d+):\d+', r'\1:...'),
    (r'\b(pid|process) \d+', r'\1 ...'))]


def plain(text):
    """Return a text without terminal escapes and without what differs from run to run."""
    for pattern, by in CHANGING:
        text = pattern.sub(by, text)
    return text
