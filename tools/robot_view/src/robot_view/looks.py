"""The robot as its URDF describes it: boxes and cylinders in viser's scene.

yourdfpy reads all of URDF, but installs 350 MB and a second numpy, and takes 0.7 s to start.
"""

from xml.etree import ElementTree

import numpy
from sim_turtlebot.physics.description import URDF, numbers_in, origin_of, read_joints


def add_robot(scene, root, **look):
    """Add the robot's links below the node `root` of viser's scene.

    :param look: color and opacity of all shapes, in place of the URDF's colours
    :return: the viser.FrameHandle and the Joint of each link that turns
    """
    text = URDF.read_text()
    urdf = ElementTree.fromstring(text)
    joints = {joint.child: joint for joint in read_joints(text)}
    colours = {material.get('name'): numbers_in(material.find('color').get('rgba'))[:3]
               for material in urdf.iterfind('material')}
    nodes, wheels = {}, []  # nodes by link
    for link in urdf.iterfind('link'):
        name = link.get('name')
        joint, visuals = joints.get(name), link.findall('visual')
        if joint is None:
            nodes[name] = root
        elif visuals:
            nodes[name] = f'{nodes[joint.parent]}/{name}'
            frame = scene.add_frame(nodes[name], show_axes=False, position=joint.position,
                                    wxyz=wxyz(joint.rotation))
            if joint.axis:
                wheels.append((frame, joint))
        for number, visual in enumerate(visuals):
            colour = {'color': colours[visual.find('material').get('name')]}
            _add_shape(scene, f'{nodes[name]}/{number}', visual, **(look or colour))
    return wheels


def wxyz(quaternion):
    """Return a quaternion x, y, z, w in viser's order."""
    return numpy.roll(quaternion, 1)


def _add_shape(scene, name, visual, **options):
    shape, (position, rotation) = visual.find('geometry')[0], origin_of(visual)
    place = {'position': position, 'wxyz': wxyz(rotation)}
    if shape.tag == 'box':
        scene.add_box(name, dimensions=numbers_in(shape.get('size')), **place, **options)
    else:
        scene.add_cylinder(name, float(shape.get('radius')), float(shape.get('length')),
                           flat_shading=True, **place, **options)
