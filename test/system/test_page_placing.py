"""The page puts robots somewhere: where there is a simulator, the chosen one, and nowhere else."""

import pytest
from odometry_tests.robots import place
from odometry_tests.tutorial import Truth, simulator
from odometry_tests.viewing import View

raw_page = pytest.importorskip('odometry_tests.raw_page', reason='viser is not installed')

NS = '/placed/'
X, Y, HEADING, PUT = 'x (m)', 'y (m)', 'heading (degrees)', 'put here'
NONSENSE = [1e9, -10001, float('nan'), float('inf'), '3', True, None, [3.0], {}]


@pytest.fixture(scope='module')
def page(master):
    """Open the page of two simulated robots."""
    with simulator(f'__ns:={NS}', '_robots:=2'), View(f'__ns:={NS}') as view, \
            raw_page.RawPage(view.port, origin=view.url) as opened:
        opened.show()
        opened.find('robot')
        yield opened
    assert 'Traceback' not in view.process.output


@pytest.fixture(scope='module')
def truths():
    """Record where the robots are."""
    return [Truth(f'{NS}robot_{number}/') for number in (1, 2)]


def put(page, robot, x, y, heading):
    """Have the page put a robot there (m, m, degrees)."""
    page.set('robot', robot)
    for label, value in (X, x), (Y, y), (HEADING, heading):
        page.set(label, value)
    page.set(PUT, True)


def place_since(truth, message):
    """Return where a robot is, by its first message that is no older than another robot's."""
    return place(truth.wait_for(lambda m: m.header.stamp >= message.header.stamp))


def test_the_button_puts_the_chosen_robot_there(page, truths):
    """One after the other."""
    first, second = truths
    put(page, 'robot_2', 3.0, -1.5, 90)
    there = second.wait_for(lambda m: place(m) == (3.0, -1.5, 1.57), what='robot_2 where it was put')
    assert place_since(first, there) == (0.0, 0.0, 0.0)
    put(page, 'robot_1', -2, 0.25, -180)
    there = first.wait_for(lambda m: place(m)[:2] == (-2.0, 0.25), what='robot_1 where it was put')
    assert place_since(second, there) == (3.0, -1.5, 1.57)


@pytest.mark.parametrize('value', NONSENSE, ids=repr)
def test_what_is_no_coordinate_is_ignored(page, truths, value):
    """What the input said before counts."""
    first, _ = truths
    first.clear()
    put(page, 'robot_1', 4.0, 1.0, 0.0)
    first.wait_for(lambda m: place(m) == (4.0, 1.0, 0.0), what='robot_1 where it was put')
    page.set(X, value)
    page.set(Y, 2.0)
    first.clear()
    page.set(PUT, True)
    first.wait_for(lambda m: place(m) == (4.0, 2.0, 0.0), what='robot_1 at x 4 m')


def test_without_a_simulator_nothing_is_put(master):
    """Who says that the hidden button is clicked is ignored."""
    with raw_page.view_of_two('/placeless') as view, \
            raw_page.honest_page(view) as page:
        page.wait_for_text('no simulator here')
        page.click_hidden(PUT)
        view.process.wait_for_output('Update of an input that the page does not show')
