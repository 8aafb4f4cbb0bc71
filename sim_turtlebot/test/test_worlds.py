"""Worlds that are refused, each with what is wrong with it, and the shapes of the others."""

import os

import pytest
from odometry_tests.scripts import ROOT
from odometry_tests.tutorial import simulator
from odometry_tests.waiting import Recorder
from sim_turtlebot.physics.world import World
from sim_turtlebot.physics.world_file import WorldFileError
from sim_turtlebot.world_markers import make_markers
from std_msgs.msg import String
from visualization_msgs.msg import Marker, MarkerArray

STEP_RATE = 240  # Hz
START = 0.0, 0.0, 0.0
CUBE = '<collision><geometry><box size="1 1 1"/></geometry></collision>'
TWO_ROOTS = f'<robot name="r"><link name="a">{CUBE}</link><link name="b">{CUBE}</link></robot>'
MESH = ('<robot name="r"><link name="a">\n<collision><geometry><mesh filename="mesh.obj"/></geometry>'
        '</collision></link></robot>')
# Its centre of mass is off and turned, which must not move what is seen.
LINKS = '''<robot name="r"><material name="m"><color rgba="1 0.5 0 0.25"/></material>
<link name="a"><inertial><origin xyz="0.5 0 0" rpy="0 0 0.3"/><mass value="1"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="2" iyz="0" izz="3"/></inertial>
<visual><origin xyz="3 2 1"/><geometry><box size="1 2 3"/></geometry><material name="m"/></visual>
<visual><origin xyz="0 9 0"/><geometry><cylinder radius="0.2" length="0.7"/></geometry></visual></link>
<joint name="j" type="fixed"><parent link="a"/><child link="b"/><origin xyz="0 0 5" rpy="0 0 1.5708"/></joint>
<link name="b"><visual><origin xyz="4 0 0"/><geometry><sphere radius="0.5"/></geometry></visual></link></robot>'''


WITHOUT_INERTIA = ('<sdf version="1.4"><world name="w"><model name="m"><link name="board"><inertial><mass>1</mass>'
                   '</inertial></link></model></world></sdf>')
INCLUDES = '<sdf version="1.6"><world name="w">{}</world></sdf>'.format(''.join(
    f'<include><uri>model://{name}</uri></include>' for name in ('ground_plane', 'sun', 'cinder_block', 'dumpster')))


@pytest.mark.parametrize('name, text, reason', [
    ('no_such_file.urdf', None, 'there is none'),
    ('folder.urdf', None, 'is a folder'),
    ('', None, 'the name of a .urdf or .sdf file'),
    ('unclosed.urdf', '<robot name="r">\n<link name="a">\n</robot>', 'Line number=2'),
    ('playground.world', WITHOUT_INERTIA, 'must have inertia element Could not parse inertial element for Link: board '),
    ('two_roots.urdf', TWO_ROOTS, 'multiple root links found: a b'),
    ('no_mesh.urdf', MESH, "no_mesh.urdf:2: cannot find 'mesh.obj'")])
def test_a_file_that_pybullet_cannot_load_is_refused_with_its_reason(tmp_path, name, text, reason):
    os.mkdir(tmp_path / 'folder.urdf')
    if text is not None:
        (tmp_path / name).write_text(text)
    with pytest.raises(WorldFileError) as refusal:
        World(STEP_RATE, [], world_file=str(tmp_path / name))
    assert reason in str(refusal.value)
    assert len(str(refusal.value).splitlines()) == 1
    assert 'No inertial data' not in str(refusal.value)


@pytest.mark.parametrize('make, limit, reason', [
    (os.mkdir, 30, 'PyBullet ends by SIGABRT'), (os.mkfifo, 1, 'not within 1 s')])
def test_a_file_over_which_pybullet_ends_or_waits_for_ever_is_refused(
        tmp_path, monkeypatch, make, limit, reason):
    """A mesh that is a folder, or a pipe to which nobody writes."""
    monkeypatch.setattr('sim_turtlebot.physics.world_file.LONGEST_LOAD', limit)
    make(tmp_path / 'mesh.obj')
    (tmp_path / 'world.urdf').write_text(MESH)
    with pytest.raises(WorldFileError, match=reason):
        World(STEP_RATE, [], world_file=str(tmp_path / 'world.urdf'))


def test_models_that_a_world_includes_are_said_to_be_left_out(tmp_path, simulated_time):
    """Also to those who do not read the log; there is a floor, and nobody needs a sun."""
    path = tmp_path / 'includes.world'
    path.write_text(INCLUDES)
    with simulator(f'_world:={path}') as running:
        warning = Recorder('sim_turtlebot/warning', String).wait_for(lambda m: m.data).data
    assert warning.startswith(f'{path} includes model://cinder_block, model://dumpster, which PyBullet does not load')
    assert warning in running.output


def box(size, position):
    """Return a collision element; sizes and positions as in a URDF."""
    return (f'<collision><origin xyz="{position}"/><geometry><box size="{size}"/></geometry>'
            '</collision>')


def settled(tmp_path, obstacle, starts=(START,)):
    """Return the robots of a world with an obstacle, settled at their starts."""
    path = tmp_path / 'box.urdf'
    path.write_text(f'<robot name="r"><link name="a">{obstacle}</link></robot>')
    return World(STEP_RATE, starts, world_file=str(path)).robots


@pytest.mark.parametrize('obstacle, starts, words', [
    (box('0.1 4 0.5', '0.22 0 0.25'), [START], 'the robot, at x 0, y 0, is 0.009 m'),  # a wall that touches it
    (box('10 10 1', '0 0 -0.3'), [START], 'is 0.200 m'),  # a step on which it would be thrown
    (box('0.1 0.1 0.5', '0 1 0.25'), [START, (0.0, 1.0, 0.0)], 'robot_2, at x 0, y 1, is 0.1')])
def test_a_world_where_a_robot_starts_is_refused_with_robot_and_depth(tmp_path, obstacle, starts, words):
    with pytest.raises(WorldFileError) as refusal:
        settled(tmp_path, obstacle, starts)
    assert words in str(refusal.value)
    assert len(str(refusal.value).splitlines()) == 1


@pytest.mark.parametrize('height', [-0.5, 0.0, 0.03, 0.05])
def test_a_floor_of_the_worlds_own_bears_the_robot(tmp_path, height):
    robot, = settled(tmp_path, box('10 10 1', f'0 0 {height - 0.5}'))
    (x, y, z), _ = robot.pose()
    assert (x, y) == (0.0, 0.0)
    assert z == pytest.approx(max(height, 0.0), abs=1e-3)


def test_a_world_is_rebuilt_without_its_file(tmp_path):
    path = tmp_path / 'wall.urdf'
    path.write_text(f'<robot name="r"><link name="a">{box("0.1 4 0.5", "1 0 0.25")}</link></robot>')
    world = World(STEP_RATE, [START], world_file=str(path))
    path.unlink()
    world.rebuild()
    robot, = world.robots
    assert robot.cast_rays([[0, 0, 0.2]], [[1.9, 0, 0.2]]) == [pytest.approx(0.5)]


def test_the_walls_and_boxes_of_the_room_arrive_late_too(simulated_time):
    with simulator(f'_world:={ROOT}/sim_turtlebot/worlds/room.urdf') as running:
        running.wait_for_output('TurtleBot 2 ready')
        first, *shapes = Recorder('sim_turtlebot/world_markers', MarkerArray).wait_for().markers
    assert first.action == Marker.DELETEALL
    assert {(shape.type, shape.header.frame_id) for shape in shapes} == {(Marker.CUBE, 'world')}
    assert len({shape.id for shape in shapes}) == 7


def test_a_shape_stands_where_the_file_puts_it(tmp_path):
    path = tmp_path / 'links.urdf'
    path.write_text(LINKS)
    box, cylinder, sphere = make_markers(World(240, [(0.0, 0.0, 0.0)], world_file=str(path)))
    assert (box.type, cylinder.type, sphere.type) == (Marker.CUBE, Marker.CYLINDER, Marker.SPHERE)
    assert numbers(box.pose.position) == pytest.approx((3, 2, 1)) and numbers(box.scale) == pytest.approx((1, 2, 3))
    assert numbers(box.pose.orientation) == pytest.approx((0, 0, 0, 1), abs=1e-6)
    assert numbers(box.color) == pytest.approx((1, 0.5, 0, 0.25))
    assert numbers(cylinder.pose.position) == pytest.approx((0, 9, 0))
    assert numbers(cylinder.scale) == pytest.approx((0.4, 0.4, 0.7))
    assert numbers(sphere.pose.position) == pytest.approx((0, 4, 5), abs=1e-4)
    assert numbers(sphere.scale) == pytest.approx((1, 1, 1))


def numbers(message):
    """Return the fields of a message."""
    return [getattr(message, name) for name in message.__slots__]
