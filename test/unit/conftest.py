"""Settings of the unit tests."""

import importlib.util
import os
from pathlib import Path

from hypothesis import settings

ROOT = Path(__file__).resolve().parents[2]

settings.register_profile('ci', max_examples=300, deadline=None)
settings.register_profile('nightly', max_examples=10000, deadline=None)
settings.load_profile(os.environ.get('HYPOTHESIS_PROFILE', 'ci'))


def load_script(path):
    """Import a node's script, which lies in no Python package, by its path in the project."""
    spec = importlib.util.spec_from_file_location(Path(path).stem, ROOT / path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
