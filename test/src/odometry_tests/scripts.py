"""The files of the project; the nodes' scripts, which lie in no Python package, as modules."""

import importlib.util
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
DOCUMENTS = [ROOT / 'README.md', ROOT / 'CONTRIBUTING.md', *sorted(ROOT.glob('[!.]*/*.md')),
             *sorted(ROOT.glob('tools/*/*.md'))]


def load_script(path):
    spec = importlib.util.spec_from_file_location(Path(path).stem, ROOT / path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
