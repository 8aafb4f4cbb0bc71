"""How the viewer ends."""

from types import SimpleNamespace

import pytest
import rospy

pytest.importorskip('viser', reason='viser is not installed')

from robot_view.node import Viewer


def test_a_shutdown_that_began_before_there_was_a_hook_for_it_is_noticed(monkeypatch):
    """First rospy goes through its hooks, and only then it says that it is shut down."""
    monkeypatch.setattr(rospy, 'Subscriber', lambda *_: None)
    monkeypatch.setattr(rospy.core, '_client_shutdown_hooks', [])
    monkeypatch.setattr(rospy.core, '_in_shutdown', True)
    page = SimpleNamespace(is_open=False, wake=lambda: None, set_robots=lambda _: None,
                           wait=lambda: pytest.fail('it would wait for ever'))
    Viewer(page).run()
