"""Worlds that are refused, each with what is wrong with it, before a robot moves in them."""

import os

import pytest
from sim_turtlebot.physics.world import World
from sim_turtlebot.physics.world_file import WorldFileError

STEP_RATE = 240  # Hz
START = 0.0, 0.0, 0.0
BOX = '<collision><geometry><box size="1 1 1"/></geometry></collision>'
TWO_ROOTS = f'<robot name="r"><link name="a">{BOX}</link><link name="b">{BOX}</link></robot>'
MESH = ('<robot name="r"><link name="a">\n<collision><geometry><mesh filename="mesh.obj"/></geometry>'
        '</collision></link></robot>')


@pytest.mark.parametrize('name, text, reason', [
    ('no_such_file.urdf', None, 'there is none'),
    ('folder.urdf', None, 'is a folder'),
    ('', None, 'the name of a .urdf or .sdf file'),
    ('unclosed.urdf', '<robot name="r">\n<link name="a">\n</robot>', 'Line number=2'),
    ('empty.urdf', '', 'Cannot load URDF file'),
    ('text.sdf', 'hello', 'Line number=1'),
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
    assert 'inertial' not in str(refusal.value)


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
    (box('0.1 4 0.5', '0 0 0.25'), [START], 'the robot, at x 0, y 0, is 0.180 m'),  # a wall through its middle
    (box('0.1 4 0.5', '0.22 0 0.25'), [START], 'is 0.009 m'),  # a wall that touches it
    (box('10 10 1', '0 0 0.8'), [START], 'is 0.110 m'),  # a ceiling too low
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
