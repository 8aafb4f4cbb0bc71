"""Check the poses that users request."""

import math

FRAMES = 'world', ''  # empty: not given
MAX_COORDINATE = 1e4  # m; PyBullet's single precision is too coarse beyond
COORDINATES = f'from {-MAX_COORDINATE:.0f} to {MAX_COORDINATE:.0f}'
MIN_LENGTH = 1e-100  # of a quaternion


def checked_pose(frame, position, orientation):
    """Return the position, and the orientation with length 1.

    :param frame: frame_id of the pose
    :param position: x, y, z (m)
    :param orientation: quaternion x, y, z, w of any length
    :raises ValueError: if the pose is not possible; the message says why, and what is allowed
    """
    if frame not in FRAMES:
        raise ValueError(f'frame_id is {frame!r}, but must be world, or empty')
    for name, value in zip('xyz', position):
        if not abs(value) <= MAX_COORDINATE:
            raise ValueError(f'{name} is {value:g} m, but must be {COORDINATES} m')
    length = math.hypot(*orientation)
    if not MIN_LENGTH < length < math.inf:
        numbers = ' '.join(f'{number:g}' for number in orientation)
        raise ValueError(f'the orientation is [{numbers}], but must be a quaternion, finite and '
                         'not zero')
    return tuple(position), tuple(number / length for number in orientation)
