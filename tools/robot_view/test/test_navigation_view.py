"""The camera that shows everything, and a map's cells, as numbers."""

import math

import numpy
import pytest
from nav_msgs.msg import OccupancyGrid
from robot_view.camera import DIRECTION, TANGENT, look_at_all, look_at_robot, shows
from robot_view.navigation import HEIGHT, occupied_cells

DESKTOP, PHONE = 960 / 720, 390 / 464  # aspects of the scene
FAR = 4 * math.cos(math.radians(65)), 4 * math.sin(math.radians(65))
BENT = [(0, 0), (4, 0), (4 + FAR[0], FAR[1])]  # 4 m, a turn of 65 degrees, and 4 m more


class Camera:
    """A camera as viser has it, and what it sees."""

    def __init__(self, aspect):
        self.aspect = aspect

    def project(self, place):
        """Return how far x, y, z (m) is from the middle of the picture; its edges are at 1."""
        forward = numpy.subtract(self.look_at, self.position)
        forward /= numpy.linalg.norm(forward)
        right = numpy.cross(forward, (0, 0, 1))
        right /= numpy.linalg.norm(right)
        seen = numpy.subtract(place, self.position)
        depth = seen @ forward * TANGENT
        return abs(seen @ right) / depth / self.aspect, abs(seen @ numpy.cross(right, forward)) / depth


@pytest.mark.parametrize('aspect', [DESKTOP, PHONE], ids=['desktop', 'phone'])
@pytest.mark.parametrize('path', [BENT, [(x, -y) for x, y in BENT], [(0, 0)], [(0, -30), (0, 30)]], ids=str)
def test_all_places_are_in_view_with_the_robots_there_and_little_else(aspect, path):
    camera = Camera(aspect)
    look_at_all(camera, path)
    seen = numpy.array([camera.project((*place, z)) for place in path for z in (0, 0.4)])
    assert seen.max() < 1, seen
    outer = numpy.array([camera.project((x + dx, y + dy, 0)) for x, y in path for dx in (-1, 1) for dy in (-1, 1)])
    assert outer.max() > 1, 'the camera is too far away'
    assert numpy.allclose(numpy.subtract(camera.position, camera.look_at) / numpy.linalg.norm(
        numpy.subtract(camera.position, camera.look_at)), DIRECTION, atol=0.01)


@pytest.mark.parametrize('place, expected', [((0, 0), True), ((1, 0), True), ((-3, 0), False), ((0, -4), False)])
def test_whether_a_start_is_in_view_beside_a_robot(place, expected):
    camera = Camera(DESKTOP)
    look_at_robot(camera)
    assert (max(camera.project((*place, 0))) < 1) == shows(camera, place) == expected


def test_a_maps_occupied_cells_are_where_it_has_them():
    grid = OccupancyGrid(data=[0, 100, -1, 0, 0, 65])
    grid.info.width, grid.info.height, grid.info.resolution = 3, 2, 0.5
    grid.info.origin.position.x, grid.info.origin.position.y = -1.0, 2.0
    assert occupied_cells(grid).tolist() == [[-0.25, 2.25, HEIGHT], [0.25, 2.75, HEIGHT]]
    grid.data.pop()
    with pytest.raises(ValueError, match='reshape'):
        occupied_cells(grid)
