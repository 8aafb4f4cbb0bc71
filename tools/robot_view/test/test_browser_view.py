"""What a browser shows of a drive that it has not seen, on a screen of any size, and how it reads to anyone."""

import math
import re

import pytest
import rospy
from nav_msgs.msg import OccupancyGrid, Odometry
from odometry_tests.messages import odometry
from odometry_tests.waiting import TIMEOUT, wait_until
from viewer import DARK, browsing, viewing

LAPTOP = {'width': 1280, 'height': 720, 'deviceScaleFactor': 0.5, 'mobile': False}
PHONE = {'width': 390, 'height': 844, 'deviceScaleFactor': 0.5, 'mobile': True}
TURN = math.radians(65)
MARK_PIXELS = 4
MAP_PIXELS = 300
LEAST_CONTRAST = 4.5  # of text, by WCAG 2
CANVAS_HEIGHT = 'return document.querySelector("canvas").getBoundingClientRect().height'
FOLD = ('[...document.getElementById("readings").closest("[style*=fixed]").querySelectorAll("div")]'
        '.find((part) => part.style.cursor == "pointer" && part.style.height == "3.5em").click()')
SCHEME = 'return document.documentElement.dataset.mantineColorScheme'
IS_NAMELESS = 'field.getBoundingClientRect().width && !field.ariaLabel && !field.labels?.length'
NAMELESS = ('return [...document.querySelectorAll("[role=slider], #root input:not([type=hidden])")]'
            f'.filter((field) => {IS_NAMELESS}).map((field) => field.outerHTML)')
# Those of one colour; the others have an outline in it.
BUTTONS = ('return [...document.querySelectorAll("button.mantine-Button-root[data-variant=filled]")].map((button) => '
           '[button.innerText, getComputedStyle(button).color, getComputedStyle(button).backgroundColor])')


@pytest.fixture(scope='module')
def open_page(master):
    """Return a function that opens a page after a robot has driven 4 m, turned by 65 degrees, and driven 4 m more."""
    rospy.set_param('/use_sim_time', True)
    with viewing() as view, browsing() as opened:
        publisher = rospy.Publisher('/odom', Odometry, queue_size=200)
        wait_until(publisher.get_num_connections, TIMEOUT, 'a viewer that listens')
        places = [(0.1 * step, 0.0, 0.0) for step in range(41)]
        places += [(4 + 0.1 * step * math.cos(TURN), 0.1 * step * math.sin(TURN), TURN) for step in range(1, 41)]
        for number, place in enumerate(places):
            publisher.publish(odometry(*place, stamp=0.1 * number))
        yield lambda: opened(view.url)


@pytest.fixture(scope='module')
def page(open_page):
    return open_page()


def seen(page):
    """Return how many pixels of the start, and of the dark robot, the picture has, and how many of that at its edge."""
    dark = page.scene().max(axis=2) < DARK
    edge = dark[[0, -1]].sum() + dark[:, [0, -1]].sum()
    return page.count_pixels(1, 0), dark.sum(), edge


def wait_for_all(page):
    wait_until(lambda: seen(page)[0] > MARK_PIXELS < seen(page)[1] and not seen(page)[2], TIMEOUT,
               lambda: f'start and robot in the picture, whose pixels are {seen(page)}')


@pytest.mark.parametrize('size', [LAPTOP, PHONE], ids=['laptop', 'phone'])
def test_the_whole_path_is_in_view_when_a_page_is_opened_late_and_on_a_click(page, size):
    with page.resized(size):
        page.open(page.current_url)
        wait_for_all(page)
        page.wait_for_reading('heading', lambda degrees: degrees == pytest.approx(65, abs=0.1))
        page.follow()
        wait_until(lambda: seen(page)[0] < MARK_PIXELS, TIMEOUT, 'a start that is out of view beside the robot')
        page.click('show all')
        wait_for_all(page)


def test_following_belongs_to_one_browser(page, open_page):
    other = open_page()
    wait_for_all(other)
    other.follow()
    page.click('show all')
    wait_until(lambda: not page.follows, TIMEOUT, 'a browser that does not follow')
    assert other.follows


def test_the_scene_grows_when_the_panel_is_folded_on_a_phone(page):
    with page.resized(PHONE):
        before = page.run(CANVAS_HEIGHT)
        page.run(FOLD)
        wait_until(lambda: page.run(CANVAS_HEIGHT) > 1.5 * before, TIMEOUT, 'a taller scene')
        page.run(FOLD)
        wait_until(lambda: page.run(CANVAS_HEIGHT) == before, TIMEOUT, 'the scene as it was')


def test_a_map_is_drawn(page):
    publisher = rospy.Publisher('/map', OccupancyGrid, queue_size=1, latch=True)
    grid = OccupancyGrid(data=[100] * 1600)
    grid.info.width = grid.info.height = 40
    grid.info.resolution, grid.info.origin.position.x = 0.05, 1.0
    before = seen(page)[1]
    publisher.publish(grid)
    wait_until(lambda: seen(page)[1] > before + MAP_PIXELS, TIMEOUT, 'a dark square in the picture')


@pytest.mark.parametrize('scheme', ['light', 'dark'])
def test_the_page_follows_the_browsers_colours_and_can_be_read(page, scheme):
    page.execute_cdp_cmd('Emulation.setEmulatedMedia', {
        'features': [{'name': 'prefers-color-scheme', 'value': scheme}]})
    wait_until(lambda: page.run(SCHEME) == scheme, TIMEOUT, lambda: f'{scheme} colours, not {page.run(SCHEME)}')
    page.wait_for_text('forward')
    assert page.title == 'TurtleBot 2'
    wait_until(lambda: not page.run(NAMELESS), TIMEOUT, lambda: f'a name for {page.run(NAMELESS)}')
    low = {text: contrast(*colours) for text, *colours in page.run(BUTTONS) if contrast(*colours) < LEAST_CONTRAST}
    assert not low, 'white on these is hard to read'
    assert not page.run('return document.querySelector("[class*=Notification-root]")'), page.text


def contrast(one, other):
    """Return the contrast of two CSS colours by WCAG 2."""
    lighter, darker = sorted(map(luminance, (one, other)), reverse=True)
    return (lighter + 0.05) / (darker + 0.05)


def luminance(colour):
    shares = [int(number) / 255 for number in re.findall(r'\d+', colour)[:3]]
    linear = [share / 12.92 if share <= 0.04 else ((share + 0.055) / 1.055) ** 2.4 for share in shares]
    return sum(weight * share for weight, share in zip((0.2126, 0.7152, 0.0722), linear))
