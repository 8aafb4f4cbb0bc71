"""Make the pictures in docs/images again: ./ws python3 test/tools/screenshots.py [NAME...].

Needs what ./ws test needs, and ./ws installs: Chromium and its driver, Xvfb, RViz.
"""

import argparse
import re

import rospy
from odometry_tests.processes import Master, Process, hold_port, rosrun
from odometry_tests.screen import colours, photograph, virtual_screen
from odometry_tests.scripts import ROOT
from odometry_tests.tutorial import Truth
from odometry_tests.waiting import wait_until
from PIL import Image

IMAGES = ROOT / 'docs' / 'images'
DRAWN = 100  # colours on a screen on which a robot has been drawn
START_TIMEOUT = 60.0  # s
DRIVE_TIMEOUT = 60.0  # s
MOMENT = 1.3  # m from the start, where the robot is photographed


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('names', nargs='*', metavar='NAME', help=f'some of {", ".join(PICTURES)}')
    names = parser.parse_args().names or list(PICTURES)
    with Master(use_sim_time=True):
        rospy.init_node('screenshots', anonymous=True, disable_rostime=True)
        for name in names:
            save(PICTURES[name](), name)


def save(image, name):
    """Write an image as a small PNG."""
    path = IMAGES / f'{name}.png'
    image.convert('RGB').save(path, optimize=True)
    print(f'{path.relative_to(ROOT)}: {path.stat().st_size // 1000} kB')


def view():
    from odometry_tests.browser import Page
    with hold_port() as port, rosrun('robot_view', 'view.py', f'_port:={port}') as viewer:
        url = f'http://localhost:{port}'
        viewer.wait_for_output(url)
        with Page(url, 1280, 760) as page:
            return drive_before(page)


def drive_before(page):
    """Return what a page shows of a robot on its way."""
    page.dismiss_notices()
    # The page is there first, and sees all of the way.
    with launched():
        page.wait_for_reading('moved_distance', lambda metres: metres > MOMENT, DRIVE_TIMEOUT)
        return page.photograph()


def rviz():
    return photograph_screen('rviz:=true', (1100, 768))


def gui():
    return photograph_screen('gui:=true', (1024, 768))


def run():
    """Return the picture that a demo leaves."""
    with Process(ROOT / 'ws', 'demo') as demo:
        assert demo.wait(START_TIMEOUT + DRIVE_TIMEOUT) == 0, demo.output
    return Image.open(re.search(r'picture +(.*)', demo.stdout)[1])


def launched(*arguments):
    return Process('roslaunch', 'odometry_launch', 'move_two_meters.launch', *arguments)


def photograph_screen(argument, size):
    """Return what a launch argument brings to a screen of this size."""
    with virtual_screen(*size), launched(argument):
        truth = Truth()
        wait_until(lambda: colours() > DRAWN, START_TIMEOUT, 'a robot on the screen')
        truth.wait_for(lambda m: m.pose.pose.position.x > MOMENT, DRIVE_TIMEOUT)
        return photograph()


PICTURES = {function.__name__: function for function in (view, rviz, gui, run)}

if __name__ == '__main__':
    main()
