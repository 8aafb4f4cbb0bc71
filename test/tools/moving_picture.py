"""Record docs/images/demo.gif from a run of ./ws demo --view: ./ws python3 test/tools/moving_picture.py.

Needs what ./ws test installs: Chromium and selenium. The GIF shows the page above the terminal, faster than real time.
"""

import os
import re
import subprocess
import sys
import time

from odometry_tests.forms import ESCAPE
from odometry_tests.scripts import ROOT, load_script
from odometry_tests.terminal import Terminal
from odometry_tests.waiting import wait_until
from PIL import Image, ImageDraw, ImageFont

browser = load_script('tools/robot_view/test/browser.py')
FILE = ROOT / 'docs/images/demo.gif'
MAX_SIZE = 1_000_000  # bytes
COMMAND = './ws demo --view'
# Unlike selenium, it does not scroll to the button.
SHOW_ALL = '[...document.querySelectorAll("button")].find((button) => button.innerText == "show all").click()'
STAYS = 'The page stays'  # what the demo prints last
WIDTH, PAGE_HEIGHT = 880, 480  # pixels
WINDOW = {'width': WIDTH, 'height': PAGE_HEIGHT, 'deviceScaleFactor': 1, 'mobile': False}
ROWS, ROW_HEIGHT, FONT_SIZE, MARGIN = 7, 18, 14, 8  # lines of the terminal; pixels
BLACK, WHITE = '#1e1e1e', '#e8e8e8'
PERIOD = 0.5  # s between two pictures
SHOWN, LAST_SHOWN = 130, 4000  # ms for which the GIF shows a picture, and the last one


def main():
    """Record the run, and write the GIF."""
    frames = record()
    palette = frames[-1].quantize()
    first, *others = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames]
    durations = [SHOWN] * len(others) + [LAST_SHOWN]
    first.save(FILE, save_all=True, append_images=others, duration=durations, loop=0, optimize=True)
    size = FILE.stat().st_size
    print(f'{FILE}: {len(frames)} pictures, {size} bytes')
    return int(size > MAX_SIZE)


def record():
    """Return a picture of the page and the terminal for each PERIOD of the run."""
    font_file = subprocess.check_output(['fc-match', '--format', '%{file}', 'monospace'], text=True)
    font = ImageFont.truetype(font_file, FONT_SIZE)
    with browser.Page() as window, window.resized(WINDOW), Terminal(ROOT, dict(os.environ)) as terminal:
        # A page that is open connects to the next demo at once; a new one takes half the run to draw.
        window.open(start(terminal, f'{COMMAND} --real-time-factor 0'))
        terminal.wait_for_output(STAYS, browser.ANSWER_TIMEOUT)
        stop(terminal)
        start(terminal, COMMAND)
        window.wait_for_reading('moved_distance', lambda metres: 0.0 < metres < 1.0)
        window.run(SHOW_ALL)
        frames, due = [], time.monotonic()
        while STAYS not in terminal.text:
            assert terminal.status is None, terminal.output
            frames.append(framed(terminal, window, font))
            due = max(due + PERIOD, time.monotonic())
            time.sleep(max(0.0, due - time.monotonic()))
        frames.append(framed(terminal, window, font))
        stop(terminal)
    return frames


def start(terminal, command):
    """Start a demo, and return the address of its page."""
    terminal.type(command)
    return wait_until(lambda: re.search(r'^view +(\S+)', '\n'.join(printed(terminal)), re.MULTILINE),
                      browser.ANSWER_TIMEOUT, 'the address of the page')[1]


def stop(terminal):
    terminal.press_ctrl_c()
    terminal.wait_for_prompt()


def printed(terminal):
    """Return the lines that a reader sees, live lines as they are now."""
    _, *lines = ESCAPE.sub('', terminal.text).replace('\r\n', '\n').split('\n')
    return [f'$ {COMMAND}', *(re.split('\r', line.rstrip('\r'))[-1] for line in lines)]


def framed(terminal, window, font):
    """Return the page with the last lines of the terminal below it."""
    picture = Image.new('RGB', (WIDTH, PAGE_HEIGHT + ROWS * ROW_HEIGHT + 2 * MARGIN), BLACK)
    picture.paste(window.picture(), (0, 0))
    draw = ImageDraw.Draw(picture)
    for row, line in enumerate([line for line in printed(terminal) if line][-ROWS:]):
        draw.text((MARGIN, PAGE_HEIGHT + MARGIN + row * ROW_HEIGHT), line, WHITE, font)
    return picture


if __name__ == '__main__':
    sys.exit(main())
