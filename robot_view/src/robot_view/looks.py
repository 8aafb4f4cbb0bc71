"""The shape of the robot: the boxes and cylinders in its URDF.

yourdfpy reads all of URDF, but installs 350 MB and a second numpy, and takes 0.7 s to start.
"""

from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree

import rospkg
from odometry_common.geometry import from_rpy


class Shape(NamedTuple):
    """A box or a cylinder."""

    size: tuple  # m; x, y, z of a box, radius and length of a cylinder
    position: tuple  # x, y, z (m) in the link
    rotation: tuple  # quaternion x, y, z, w
    colour: tuple  # red, green, blue (0 to 255)


class Link(NamedTuple):
    """A link with its shapes, in its parent."""

    path: str  # names of the links from the root down to this one
    joint: str  # to its parent; '' for the root
    position: tuple  # x, y, z (m)
    rotation: tuple  # quaternion x, y, z, w; of a joint at zero
    axis: tuple  # about which the joint turns; None if it is fixed
    shapes: list


def load_links():
    """Return the root and the visible Links of the URDF, parents first."""
    package = rospkg.RosPack().get_path('sim_turtlebot')
    urdf = ElementTree.parse(Path(package, 'urdf', 'turtlebot2.urdf'))
    joints = {joint.find('child').get('link'): joint for joint in urdf.iterfind('joint')}
    colours = {material.get('name'): _colour(material) for material in urdf.iterfind('material')}
    links = {}
    for element in urdf.iterfind('link'):
        name = element.get('name')
        joint = joints.get(name, ElementTree.Element('joint', name=''))
        parent, axis = joint.find('parent'), joint.find('axis')
        links[name] = Link(
            f'{"" if parent is None else links[parent.get("link")].path}/{name}', joint.get('name'),
            *_origin(joint), None if axis is None else _numbers(axis.get('xyz')),
            [_shape(visual, colours) for visual in element.iterfind('visual')])
    return [link for link in links.values() if link.shapes or not link.joint]


def _shape(visual, colours):
    geometry = visual.find('geometry')[0]
    attributes = ['size'] if geometry.tag == 'box' else ['radius', 'length']
    return Shape(_numbers(' '.join(geometry.get(name) for name in attributes)), *_origin(visual),
                 colours[visual.find('material').get('name')])


def _origin(element):
    origin = element.find('origin')
    attributes = {} if origin is None else origin.attrib
    return (_numbers(attributes.get('xyz', '0 0 0')), from_rpy(*_numbers(attributes.get('rpy', '0 0 0'))))


def _numbers(text):
    return tuple(map(float, text.split()))


def _colour(material):
    return tuple(round(255 * value) for value in _numbers(material.find('color').get('rgba'))[:3])
