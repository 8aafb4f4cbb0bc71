"""The robot's looks: the boxes and cylinders in its URDF.

yourdfpy reads all of URDF, but installs 350 MB with a second numpy, and the page would start 0.7 s
later.
"""

from typing import NamedTuple
from xml.etree import ElementTree

from sim_turtlebot.description import URDF, Joint, numbers_in, origin_of, read_joints

GREY = (128, 128, 128)


class Shape(NamedTuple):
    """A box or a cylinder."""

    size: tuple  # m; x, y, z of a box, radius and length of a cylinder
    position: tuple  # x, y, z (m) in the link
    rotation: tuple  # quaternion x, y, z, w
    colour: tuple  # red, green, blue (0 to 255)


class Link(NamedTuple):
    """A link with its shapes."""

    path: str  # names of the links from the root down to this one
    joint: Joint  # that holds it; None for the root
    shapes: list


def load_links():
    """Return the root and the visible Links of the URDF, in which parents come first."""
    urdf = URDF.read_text()
    root = ElementTree.fromstring(urdf)
    joints = {joint.child: joint for joint in read_joints(urdf)}
    colours = {material.get('name'): _colour(material) for material in root.iterfind('material')}
    links = {}
    for element in root.iterfind('link'):
        name = element.get('name')
        joint = joints.get(name)
        parent = links[joint.parent].path if joint else ''
        shapes = [_shape(visual, colours) for visual in element.iterfind('visual')]
        links[name] = Link(f'{parent}/{name}', joint, shapes)
    return [link for link in links.values() if link.shapes or not link.joint]


def _shape(visual, colours):
    geometry, material = visual.find('geometry')[0], visual.find('material')
    attributes = ['size'] if geometry.tag == 'box' else ['radius', 'length']
    return Shape(numbers_in(' '.join(geometry.get(name) for name in attributes)), *origin_of(visual),
                 GREY if material is None else colours[material.get('name')])


def _colour(material):
    return tuple(round(255 * value) for value in numbers_in(material.find('color').get('rgba'))[:3])
