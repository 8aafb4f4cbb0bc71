"""The guard stands at the server that viser makes, or there is no page."""

import pytest

viser = pytest.importorskip('viser', reason='viser is not installed')

from odometry_common.parameters import StartError
from odometry_tests.processes import hold_port
from robot_view.guard import guarded
from websockets.asyncio import server


def test_a_server_that_is_made_in_another_way_is_refused():
    """Another version of viser would let everybody in."""
    with pytest.raises(StartError, match='version of viser'), guarded(None, None):
        pass


def test_servers_of_others_are_not_guarded():
    """The function that makes them is as before."""
    serve = server.serve
    with pytest.raises(ZeroDivisionError), guarded(None, None):
        raise ZeroDivisionError
    assert server.serve is serve


def test_viser_has_the_inputs_of_a_page_where_they_are_looked_for():
    """It has no public name for them: another version may have another one."""
    with hold_port() as port:
        server = viser.ViserServer('localhost', port, verbose=False)
        button = server.gui.add_button('stop')
        assert list(server.gui._gui_input_handle_from_uuid.values()) == [button]
        server.stop()
