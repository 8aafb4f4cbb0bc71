"""The robot's URDF as meshes: one for each link and colour, of boxes and cylinders.

yourdfpy reads all of URDF, but installs 350 MB with a second numpy, and would make the page start
0.7 s later.
"""

from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree

import numpy
import trimesh
from viser.transforms import SE3, SO3

GREY = (128, 128, 128)
CYLINDER_SECTIONS = 48


class Link(NamedTuple):
    """A link, where it is, and what it looks like."""

    path: str  # names of the links from the root down to this one
    position: numpy.ndarray  # in the parent link (m)
    rotation: SO3
    meshes: dict  # trimesh.Trimesh by colour: red, green, blue (0 to 255)
    joint: str = ''  # that moves it, if one does
    axis: numpy.ndarray = None  # of that joint


def load_links(path):
    """Return the Links of a URDF file, parents first."""
    root = ElementTree.fromstring(Path(path).read_text())
    colours = {material.get('name'): _colour(material) for material in root.findall('material')}
    joints = {joint.find('child').get('link'): joint for joint in root.findall('joint')}
    links = []
    paths = {}
    # Parents come before their children in ours.
    for element in root.findall('link'):
        name = element.get('name')
        joint = joints.get(name)
        if joint is not None and element.find('visual') is None:
            continue  # nothing to be seen: a frame for tf
        parent = '' if joint is None else paths[joint.find('parent').get('link')]
        paths[name] = f'{parent}/{name}'
        links.append(_link(paths[name], joint, _meshes(element, colours)))
    return links


def _link(path, joint, meshes):
    origin = SE3.identity() if joint is None else _origin(joint)
    link = Link(path, origin.translation(), origin.rotation(), meshes)
    if joint is None or joint.get('type') == 'fixed':
        return link
    return link._replace(joint=joint.get('name'), axis=_numbers(joint.find('axis').get('xyz')))


def _meshes(link, colours):
    parts = {}
    for visual in link.findall('visual'):
        part = _shape(visual.find('geometry')[0])
        part.apply_transform(_origin(visual).as_matrix())
        material = visual.find('material')
        colour = GREY if material is None else colours.get(material.get('name'), GREY)
        parts.setdefault(colour, []).append(part)
    return {colour: trimesh.util.concatenate(shapes) for colour, shapes in parts.items()}


def _shape(element):
    if element.tag == 'box':
        return trimesh.creation.box(_numbers(element.get('size')))
    if element.tag == 'cylinder':
        return trimesh.creation.cylinder(
            float(element.get('radius')), float(element.get('length')),
            sections=CYLINDER_SECTIONS)
    raise ValueError(f'<{element.tag}> is not a shape that can be drawn')


def _origin(element):
    origin = element.find('origin')
    if origin is None:
        return SE3.identity()
    return SE3.from_rotation_and_translation(
        SO3.from_rpy_radians(*_numbers(origin.get('rpy', '0 0 0'))),
        _numbers(origin.get('xyz', '0 0 0')))


def _numbers(text):
    return numpy.array([float(number) for number in text.split()])


def _colour(material):
    return tuple(round(255 * value) for value in _numbers(material.find('color').get('rgba'))[:3])
