"""What a page may say: what none says is not passed on."""

from unittest import mock

import pytest
from hypothesis import given
from hypothesis import strategies as st

viser = pytest.importorskip('viser', reason='viser is not installed')

import msgspec
from robot_view.messages import checked

CAMERA = {'type': 'ViewerCameraMessage', 'wxyz': [1, 0.0, 0.0, 0.0], 'position': [0.0, 0, 1.5],
          'fov': 1.0, 'near': 0.1, 'far': 100, 'image_height': 480, 'image_width': 640,
          'look_at': [0.0, 0.0, 0.0], 'up_direction': [0, 0, 1]}
NAN, INFINITY = float('nan'), float('inf')


def handle(kind, **properties):
    """Return what passes for viser's handle of an input."""
    return mock.Mock(spec=kind, **{'label': 'input', 'visible': True, 'disabled': False,
                                   **properties})


INPUTS = {
    'button': handle(viser.GuiButtonHandle),
    'hidden': handle(viser.GuiButtonHandle, visible=False),
    'disabled': handle(viser.GuiButtonHandle, disabled=True),
    'slider': handle(viser.GuiSliderHandle, min=0.05, max=0.7),
    'number': handle(viser.GuiNumberHandle, min=-1e4, max=1e4),
    'hidden number': handle(viser.GuiNumberHandle, min=-1e4, max=1e4, visible=False),
    'list': handle(viser.GuiDropdownHandle, options=('robot_1', 'robot_2')),
    'group': handle(viser.GuiButtonGroupHandle, options=('pause', 'resume')),
    'text': handle(viser.GuiTextHandle),
}


def update(uuid, *value, **others):
    """Return a message that an input has another value."""
    return {'type': 'GuiUpdateMessage', 'uuid': uuid,
            'updates': {**({'value': value[0]} if value else {}), **others}}


def hold(uuid, frequency=10.0):
    """Return a message that a button is held."""
    return {'type': 'GuiButtonHoldMessage', 'uuid': uuid, 'frequency': frequency}


@pytest.mark.parametrize('message', [
    CAMERA, hold('button'), hold('button', 10), update('button', True), update('slider', 0.05),
    update('slider', 0.7), update('number', -1e4), update('number', 3), update('list', 'robot_2'),
    update('group', 'pause')])
def test_what_a_page_says_is_passed_on(message):
    """Unchanged."""
    passed = checked(msgspec.msgpack.encode(message), INPUTS)
    assert msgspec.msgpack.decode(passed) == message


@pytest.mark.parametrize('message', [
    *(update('slider', value) for value in (-5, 0, 0.0499, 0.701, 1e9, NAN, INFINITY, -INFINITY,
                                            '0.3', True, False, None, [0.3], {}, 2 ** 63)),
    *(update('number', value) for value in (-10001, 1e9, NAN, INFINITY, '3', True, None, [3.0],
                                            {})),
    update('hidden number', 3.0), hold('number'), update('number', 3.0, min=-1e9),
    *(update('list', value) for value in ('../evil', '', 'robot_3', 'ROBOT_1', 1, None, True,
                                          ['robot_1'])),
    *(update('group', value) for value in ('reset', '', 0, None)),
    *(update('button', value) for value in (False, 1, 'true', None)),
    update('text', 'hello'), update('nobody', True), update('hidden', True),
    update('disabled', True), hold('hidden'), hold('disabled'), hold('nobody'), hold('slider'),
    hold('list'), hold(None), hold(['button']), hold('button', NAN), hold('button', '10'),
    update('slider'), update('slider', 0.3, update_cb=[]), update('slider', update_cb=[]),
    update('list', props=None), update('button', removed=True), update(None, True),
    {**update('button', True), 'excluded_self_client': 1}, {**hold('button'), 'more': 1},
    {'type': 'GuiUpdateMessage', 'uuid': 'button', 'updates': [True]},
    {'type': 'GuiUpdateMessage', 'uuid': 'button'},
    {**CAMERA, 'position': [NAN, 0, 0]}, {**CAMERA, 'fov': INFINITY}, {**CAMERA, 'wxyz': [1.0]},
    {**CAMERA, 'look_at': None}, {'type': 'ViewerCameraMessage'},
    # Of viser's other messages, this one opens the page to the whole internet.
    {'type': 'ShareUrlRequest'}, {'type': 'ShareUrlDisconnect'},
    {'type': 'RunJavascriptMessage', 'source': 'alert(1)'},
    {'type': 'GuiRemoveMessage', 'uuid': 'button'}, {'type': 'GuiFormDirtyMessage', 'uuid': 'x'},
    {'type': 'FileTransferStartUpload', 'source_component_uuid': 'button', 'transfer_uuid': 'x',
     'filename': 'x', 'mime_type': 'x', 'part_count': 1, 'size_bytes': 1},
    {'type': 'Nonsense'}, {'type': None}, {'type': ['GuiUpdateMessage']}, {}, [], 5, None,
], ids=repr)
def test_what_no_page_says_is_not(message):
    """Values beyond the sliders, robots that are not listed, buttons that are not there."""
    with pytest.raises(ValueError, match='.'):
        checked(msgspec.msgpack.encode(message), INPUTS)


@pytest.mark.parametrize('data', ['text', b'', b'\xc1', b'\x91' * 100000, b'\xff' * 10,
                                  b'\x81\xa4type\xa3\xff\xfe\xfd',
                                  msgspec.msgpack.encode(update('button', True)) + b'\x00'])
def test_what_is_no_message_is_not_passed_on(data):
    """Noise, broken characters, something behind the message."""
    with pytest.raises(ValueError, match='.'):
        checked(data, INPUTS)


def test_what_is_said_twice_is_passed_on_once():
    """As it was checked: of two values a reader could take the one that was not checked."""
    def field(name, value):
        return msgspec.msgpack.encode(name) + msgspec.msgpack.encode(value)

    honest = update('slider', 0.3)
    twice = b'\x85' + b''.join([*(field(*item) for item in honest.items()),
                                field('updates', {'value': 0.2}), field('uuid', 'slider')])
    passed = msgspec.msgpack.decode(checked(twice, INPUTS))
    assert passed in (honest, update('slider', 0.2))
    with pytest.raises(ValueError, match='.'):
        checked(b'\x84' + twice[1:-len(field('updates', {'value': 0.2}) + field('uuid', 'slider'))]
                + field('type', 'ShareUrlRequest'), INPUTS)


@given(st.binary())
def test_any_bytes_are_passed_on_or_refused(data):
    """Nothing else is raised."""
    try:
        checked(data, INPUTS)
    except ValueError:
        pass
