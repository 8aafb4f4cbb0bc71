"""The robot's URDF: its frames for tf, and the URDF without them for PyBullet."""

import functools
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree

from sim_turtlebot.geometry import about, compose, from_rpy

# In the source folder, or below the prefix of an installed package.
URDF = next(folder / 'urdf' / 'turtlebot2.urdf'
            for folder in (Path(__file__).parents[3],
                           Path(__file__).parents[5] / 'share/sim_turtlebot')
            if (folder / 'urdf').is_dir())
BASE_JOINT = 'base_joint'
WHEEL_JOINTS = ['wheel_left_joint', 'wheel_right_joint']
BODY = 'inertial', 'collision', 'visual'


class Joint(NamedTuple):
    """Where a link is in its parent."""

    name: str
    parent: str
    child: str
    position: tuple  # x, y, z; m
    rotation: tuple  # quaternion x, y, z, w; of a joint at zero
    axis: tuple  # in the child; None if the joint is fixed

    def rotation_at(self, angle):
        """Return the rotation of a joint that has turned by an angle (rad)."""
        return compose(self.rotation, about(self.axis, angle))


def read_joints(urdf):
    """Return the Joints of a URDF (its text) in its order."""
    return [_joint(element) for element in ElementTree.fromstring(urdf).iterfind('joint')]


@functools.lru_cache(maxsize=1)
def without_frames(urdf):
    """Return a URDF (its text) without the links that are mere frames.

    These have neither mass nor shape and hang on a joint. PyBullet would give each 1 kg, and take
    time for it in each step.
    """
    root = ElementTree.fromstring(urdf)
    links = {link.get('name'): link for link in root.iterfind('link')}
    for joint in root.findall('joint'):
        link = links[joint.find('child').get('link')]
        if all(link.find(part) is None for part in BODY):
            root.remove(joint)
            root.remove(link)
    return ElementTree.tostring(root, encoding='unicode')


def numbers_in(text):
    """Return the numbers in an attribute of a URDF."""
    return tuple(float(number) for number in text.split())


def origin_of(element):
    """Return position (x, y, z; m) and rotation (quaternion x, y, z, w) of an element of a URDF."""
    origin = element.find('origin')
    attributes = {} if origin is None else origin.attrib
    return (numbers_in(attributes.get('xyz', '0 0 0')),
            from_rpy(*numbers_in(attributes.get('rpy', '0 0 0'))))


def _joint(element):
    axis = None if element.get('type') == 'fixed' else numbers_in(element.find('axis').get('xyz'))
    return Joint(element.get('name'), element.find('parent').get('link'),
                 element.find('child').get('link'), *origin_of(element), axis)
