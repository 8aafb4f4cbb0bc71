"""The shapes of a world file, as RViz and the page get them."""

import pytest
from odometry_tests.scripts import ROOT
from odometry_tests.tutorial import simulator
from odometry_tests.waiting import Recorder
from sim_turtlebot.physics.world import World
from sim_turtlebot.physics.world_shapes import BOX, CYLINDER, SPHERE, read_shapes
from visualization_msgs.msg import Marker, MarkerArray

# Its centre of mass is off and turned, which must not move what is seen.
LINKS = '''<robot name="r"><material name="m"><color rgba="1 0.5 0 0.25"/></material>
<link name="a"><inertial><origin xyz="0.5 0 0" rpy="0 0 0.3"/><mass value="1"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="2" iyz="0" izz="3"/></inertial>
<visual><origin xyz="3 2 1"/><geometry><box size="1 2 3"/></geometry><material name="m"/></visual>
<visual><origin xyz="0 9 0"/><geometry><cylinder radius="0.2" length="0.7"/></geometry></visual></link>
<joint name="j" type="fixed"><parent link="a"/><child link="b"/><origin xyz="0 0 5" rpy="0 0 1.5708"/></joint>
<link name="b"><visual><origin xyz="4 0 0"/><geometry><sphere radius="0.5"/></geometry></visual></link></robot>'''


def test_the_walls_and_boxes_of_the_room_arrive_late_too(simulated_time):
    with simulator(f'_world:={ROOT}/sim_turtlebot/worlds/room.urdf') as running:
        running.wait_for_output('TurtleBot 2 ready')
        first, *shapes = Recorder('sim_turtlebot/world_markers', MarkerArray).wait_for().markers
    assert first.action == Marker.DELETEALL
    assert {(shape.type, shape.header.frame_id) for shape in shapes} == {(Marker.CUBE, 'world')}
    assert len(shapes) == len({shape.id for shape in shapes}) == 7
    wall = shapes[0]
    assert (wall.pose.position.x, wall.pose.position.y, wall.pose.position.z) == pytest.approx((2.05, 0, 0.25))
    assert (wall.scale.x, wall.scale.y, wall.scale.z) == pytest.approx((0.1, 4.2, 0.5))
    assert (wall.color.r, wall.color.g, wall.color.b, wall.color.a) == pytest.approx((0.85, 0.82, 0.75, 1))


def test_a_shape_stands_where_the_file_puts_it(tmp_path):
    path = tmp_path / 'links.urdf'
    path.write_text(LINKS)
    box, cylinder, sphere = read_shapes(World(240, [(0.0, 0.0, 0.0)], world_file=str(path)))
    assert (box.kind, cylinder.kind, sphere.kind) == (BOX, CYLINDER, SPHERE)
    assert box.position == pytest.approx((3, 2, 1)) and box.size == pytest.approx((1, 2, 3))
    assert box.rotation == pytest.approx((0, 0, 0, 1), abs=1e-6)
    assert box.colour == pytest.approx((1, 0.5, 0, 0.25))
    assert cylinder.position == pytest.approx((0, 9, 0)) and cylinder.size == pytest.approx((0.4, 0.4, 0.7))
    assert sphere.position == pytest.approx((0, 4, 5), abs=1e-4) and sphere.size == pytest.approx((1, 1, 1))


def test_an_empty_world_has_no_shapes():
    assert read_shapes(World(240, [(0.0, 0.0, 0.0), (0.0, 1.0, 0.0)])) == []
