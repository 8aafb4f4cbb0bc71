"""Why PyBullet's window cannot be opened."""

import pytest
from sim_turtlebot.window import LIBRARIES, NoScreenError, screen


@pytest.mark.parametrize('library', ['libX11.so.6', 'libGL.so.1'])
def test_a_missing_library_is_named(monkeypatch, library):
    """It is not DISPLAY that has to be set then."""
    names = [f'no-{name}' if name == library else name for name in LIBRARIES]
    monkeypatch.setattr('sim_turtlebot.window.LIBRARIES', names)
    with pytest.raises(NoScreenError, match=f'^no-{library} is not installed$'), \
            screen():
        pass
