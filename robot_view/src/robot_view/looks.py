"""The robot as its URDF describes it: boxes and cylinders in viser's scene.

yourdfpy reads all of URDF, but installs 350 MB and a second numpy, and takes 0.7 s to start.
"""

from pathlib import Path
from typing import Any, NamedTuple
from xml.etree import ElementTree

import numpy
import rospkg
from odometry_common.geometry import about, compose, from_rpy


class Wheel(NamedTuple):
    """A link that turns."""

    frame: Any  # its viser.FrameHandle
    joint: str
    rotation: tuple  # quaternion x, y, z, w, of the joint at zero
    axis: tuple

    def turn(self, angle):
        """Draw it at an angle (rad) of its joint."""
        self.frame.wxyz = wxyz(compose(self.rotation, about(self.axis, angle)))


def load_urdf():
    """Return the root element of the robot's URDF."""
    package = rospkg.RosPack().get_path('sim_turtlebot')
    return ElementTree.parse(Path(package, 'urdf', 'turtlebot2.urdf')).getroot()


def add_robot(scene, root, urdf, **look):
    """Add the links of a URDF below the node `root` of viser's scene; return the Wheels.

    :param look: color and opacity of all shapes, in place of the URDF's colours
    """
    joints = {joint.find('child').get('link'): joint for joint in urdf.iterfind('joint')}
    colours = {material.get('name'): _numbers(material.find('color'), 'rgba')[:3]
               for material in urdf.iterfind('material')}
    nodes, wheels = {}, []  # nodes by link
    for link in urdf.iterfind('link'):
        name, joint, visuals = link.get('name'), joints.get(link.get('name')), link.findall('visual')
        if joint is None:
            nodes[name] = root
        elif visuals:
            nodes[name] = f'{nodes[joint.find("parent").get("link")]}/{name}'
            frame = scene.add_frame(nodes[name], show_axes=False, **_place(joint))
            if joint.find('axis') is not None:
                wheels.append(Wheel(frame, joint.get('name'), _rotation(joint),
                                    _numbers(joint.find('axis'), 'xyz')))
        for number, visual in enumerate(visuals):
            colour = {'color': colours[visual.find('material').get('name')]}
            _add_shape(scene, f'{nodes[name]}/{number}', visual.find('geometry')[0],
                       **_place(visual), **(look or colour))
    return wheels


def wxyz(quaternion):
    """Return a quaternion x, y, z, w in viser's order."""
    return numpy.roll(quaternion, 1)


def _add_shape(scene, name, geometry, **options):
    if geometry.tag == 'box':
        scene.add_box(name, dimensions=_numbers(geometry, 'size'), **options)
    else:
        scene.add_cylinder(name, *_numbers(geometry, 'radius'), *_numbers(geometry, 'length'),
                           flat_shading=True, **options)


def _place(element):
    return {'position': _numbers(element.find('origin'), 'xyz'), 'wxyz': wxyz(_rotation(element))}


def _rotation(element):
    return from_rpy(*_numbers(element.find('origin'), 'rpy'))


def _numbers(element, attribute):
    """Return the numbers of an attribute; those of an origin are zero if it is not there."""
    text = '0 0 0' if element is None else element.get(attribute, '0 0 0')
    return tuple(map(float, text.split()))
