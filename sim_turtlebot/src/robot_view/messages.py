"""Validation of the messages from a page: none of them is trusted.

viser sets whatever property a message names to whatever value it has: a slider to NaN, a list to
something that is not on it, the callbacks of a button to none.
"""

from typing import Tuple, Union

import msgspec
import viser
from typing_extensions import Annotated

# Also keeps out NaN.
Number = Annotated[float, msgspec.Meta(ge=-1e9, le=1e9)]
Triple = Tuple[Number, Number, Number]
Quadruple = Tuple[Number, Number, Number, Number]
Scalar = Union[bool, int, float, str]


class Message(msgspec.Struct, tag_field='type', forbid_unknown_fields=True):
    """A message; viser's name of its kind is in `type`."""


class Camera(Message, tag='ViewerCameraMessage'):
    """Where a page looks from."""

    wxyz: Quadruple
    position: Triple
    fov: Number
    near: Number
    far: Number
    image_height: Number
    image_width: Number
    look_at: Triple
    up_direction: Triple


class Hold(Message, tag='GuiButtonHoldMessage'):
    """A button is being held."""

    uuid: str
    frequency: Number


class Value(msgspec.Struct, forbid_unknown_fields=True):
    """A value, and nothing else of an input."""

    value: Scalar


class Update(Message, tag='GuiUpdateMessage'):
    """An input has another value, or a button was clicked."""

    uuid: str
    updates: Value


DECODER = msgspec.msgpack.Decoder(Union[Camera, Hold, Update])


def checked(data, inputs):
    """Return a message of a page as it may be passed on.

    It is encoded anew from what was decoded, so that viser cannot read anything else in it.

    :param data: as received on the websocket
    :param inputs: viser's handles of the page's inputs by their ids
    :raises ValueError: if it must not be passed on, with the reason
    """
    try:
        message = DECODER.decode(data)
    except (msgspec.MsgspecError, UnicodeDecodeError, TypeError) as error:
        raise ValueError(f'not a message of a page: {error}') from None
    if not isinstance(message, Camera):
        _check_input(message, inputs.get(message.uuid))
    return msgspec.msgpack.encode(message)


def _check_input(message, handle):
    if handle is None or not handle.visible or handle.disabled:
        raise ValueError(f'{type(message).__name__} of an input that the page does not show')
    is_hold = isinstance(message, Hold)
    value = 'held' if is_hold else message.updates.value
    if not (isinstance(handle, viser.GuiButtonHandle) if is_hold else _accepts(handle, value)):
        raise ValueError(f'{handle.label}: {value!r}')


def _accepts(handle, value):
    """Return whether an input can have a value."""
    if isinstance(handle, viser.GuiButtonHandle):
        return value is True
    if isinstance(handle, (viser.GuiSliderHandle, viser.GuiNumberHandle)):
        is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
        return is_number and handle.min <= value <= handle.max
    if isinstance(handle, (viser.GuiDropdownHandle, viser.GuiButtonGroupHandle)):
        return value in handle.options
    return False
