"""Nodes as learners write them: whole ones, and others that differ from one of these by a few words; what they print."""

from pathlib import Path

import yaml

ERROR = 'Traceback (most recent call last):\n  File "/home/me/a.py", line 7, in go\n    x\nNameError: no x\n'
MAIN_ERROR = ERROR.replace('  File', '  File "/home/me/a.py", line 9, in <module>\n    go()\n  File')
BAD_CALLBACK = f'[ERROR] [1.5, 0.2]: bad callback: <function cb at 0x7f00>\n{ERROR}'
NODES = Path(__file__).with_name('nodes')
# By exercise and node: `base`, what to `replace`, and the `expected` rule and hint by scenario, or of `all`.
VARIANTS = yaml.safe_load((NODES / 'variants.yaml').read_text())


def write(folder, exercise, *nodes):
    """Write nodes to a folder, and return their files."""
    files = [folder / f'{node}.py' for node in nodes]
    for node, file in zip(nodes, files):
        variant = VARIANTS[exercise][node]
        text = (NODES / exercise / f'{variant.get("base", node)}.py').read_text()
        for old, new in variant.get('replace', {}).items():
            assert old in text, f'{node}: its base has no {old!r}'
            text = text.replace(old, new)
        file.write_text(text)
    return files


def expected(exercise, node, scenario):
    """Return the rule and, if there is one, the hint that a node gets."""
    found = VARIANTS[exercise][node].get('expected', {})
    return found.get(scenario, found.get('all', 'passed'))
