"""Make the pictures in docs/images again: ./ws python3 test/tools/screenshots.py [NAME...].

Needs what ./ws test needs, and ./ws installs: Chromium and its driver, Xvfb, RViz.
"""

import argparse
import re

import rospy
from odometry_tests.processes import Master, Process, hold_port, rosrun
from odometry_tests.screen import colours, photograph, virtual_screen
from odometry_tests.scripts import ROOT, load_script
from odometry_tests.tutorial import Truth
from odometry_tests.waiting import wait_until
from PIL import Image

IMAGES = ROOT / 'docs' / 'images'
DRAWN = 100  # colours on a screen on which a robot has been drawn
COLOURS = 256  # of a picture: a palette makes it a third as large
START_TIMEOUT = 60.0  # s
DRIVE_TIMEOUT = 300.0  # s; drawing without a graphics card slows the robot
GOAL = 2.0  # m
MOMENT = 1.9  # m from the start, where the robot is photographed
CORRIDOR = f'world:={ROOT}/sim_turtlebot/worlds/corridor.urdf'


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
    # One step of k-means: without it rare colours take those of their neighbours.
    image.convert('RGB').quantize(COLOURS, kmeans=1).save(path, optimize=True)
    print(f'{path.relative_to(ROOT)}: {path.stat().st_size // 1000} kB')


def view():
    Page = load_script('robot_view/test/browser.py').Page
    with hold_port() as port, rosrun('robot_view', 'view.py', f'_port:={port}') as viewer:
        url = f'http://localhost:{port}'
        viewer.wait_for_output(url)
        # The page is there first, and sees all of the way.
        with Page(url, 1280, 760) as page, launched():
            page.dismiss_notices()
            page.wait_for_reading('moved_distance', lambda metres: metres >= GOAL, DRIVE_TIMEOUT)
            page.wait_for_reading('speed', lambda speed: speed == 0.0)
            return page.photograph()


def rviz():
    return photograph_screen((1100, 768), 'rviz:=true', 'scan:=true', CORRIDOR)


def gui():
    return photograph_screen((1024, 768), 'gui:=true').crop((112, 134, 912, 634))


def run():
    """Return the picture that a demo leaves."""
    with Process(ROOT / 'ws', 'demo') as demo:
        assert demo.wait(START_TIMEOUT + DRIVE_TIMEOUT) == 0, demo.output
    return Image.open(re.search(r'picture +(.*)', demo.stdout)[1])


def launched(*arguments):
    return Process('roslaunch', 'odometry_launch', 'move_two_meters.launch', *arguments)


def photograph_screen(size, *arguments):
    """Return the window of this size that launch arguments open."""
    width, height = size
    # The mouse pointer is in the middle of the screen, outside the window.
    with virtual_screen(3 * width, 3 * height), launched(*arguments):
        truth = Truth()
        wait_until(lambda: colours() > DRAWN, START_TIMEOUT, 'a robot on the screen')
        truth.wait_for(lambda m: m.pose.pose.position.x > MOMENT, DRIVE_TIMEOUT)
        return photograph().crop((0, 0, width, height))


PICTURES = {function.__name__: function for function in (view, rviz, gui, run)}

if __name__ == '__main__':
    main()
