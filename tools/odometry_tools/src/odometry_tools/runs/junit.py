"""Write results as CI reads them."""

from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree


class Case(NamedTuple):
    """One result."""

    group: str
    name: str
    failure: str = ''  # one line; '': it passed
    kind: str = ''  # of failure
    output: str = ''


def begin(path):
    """Empty the file, so that CI does not take an older report for that of an interrupted run.

    :raises OSError: if it cannot be written
    """
    Path(path).write_bytes(b'')


def write(path, suite, cases):
    """Write a suite of Cases in JUnit's format."""
    root = ElementTree.Element('testsuite', name=suite, tests=str(len(cases)), errors='0',
                               failures=str(sum(bool(case.failure) for case in cases)))
    for case in cases:
        element = ElementTree.SubElement(root, 'testcase', name=case.name, classname=case.group)
        if case.failure:
            ElementTree.SubElement(element, 'failure', message=case.failure, type=case.kind)
        ElementTree.SubElement(element, 'system-out').text = case.output
    ElementTree.ElementTree(root).write(path, encoding='utf-8', xml_declaration=True)
