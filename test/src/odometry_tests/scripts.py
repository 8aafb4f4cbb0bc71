"""The files of the project; the nodes' scripts, which lie in no Python package, as modules."""

import importlib.util
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
PACKAGES = sorted(path.parent for folder in ('*', 'tools/*') for path in ROOT.glob(f'{folder}/package.xml'))
TESTS = 'test', '*/test', 'tools/*/test'  # folders in ROOT
SCRIPTS = sorted(path for package in PACKAGES if package.name != 'test' for folder in ('src', 'script')
                 for path in package.glob(f'{folder}/*.py'))
DOCUMENTS = sorted(path for folder in ('.', '[!.]*', 'tools/*') for path in ROOT.glob(f'{folder}/*.md'))


def load_script(path):
    spec = importlib.util.spec_from_file_location(Path(path).stem, ROOT / path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
