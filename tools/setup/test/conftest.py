"""A checkout for each test."""

import pytest
from checkout import in_checkout, make_checkout, make_package


@pytest.fixture
def checkout(tmp_path):
    """Make a checkout with an odd path and with a package of the user's."""
    folder = make_checkout(tmp_path / "my robots/50 % of $HOME's")
    make_package(folder / '.ws/src/mine', 'pybullet')
    yield folder
    in_checkout(folder, 'find_root; rm "$ROOT"')
