"""A headless Chromium that shows the page, as a user sees and touches it."""

import contextlib
import io
import re
import shutil

import numpy
from odometry_tests.waiting import PATIENCE, wait_until
from PIL import Image
from selenium import webdriver
from selenium.webdriver import ActionChains
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.keys import Keys

CHROMIUM, DRIVER = shutil.which('chromium'), shutil.which('chromedriver')
# Without a graphics card Chromium draws with the processor, if it is told that it may.
SWITCHES = ['--headless=new', '--no-sandbox', '--disable-dev-shm-usage', '--use-gl=angle',
            '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-gpu-compositing',
            # A window that no other one covers is still hidden to Chromium.
            '--disable-backgrounding-occluded-windows', '--disable-renderer-backgrounding',
            # Few pixels: what draws without a graphics card leaves little for the robot.
            '--window-size=1200,640', '--force-device-scale-factor=0.5']
# Two pictures a second. All that wants to draw does so at the same moments, or each would get its own.
DRAW_SELDOM = ('window.requestAnimationFrame = (draw) => setTimeout('
               '() => draw(performance.now()), 500 - performance.now() % 500);'
               'window.cancelAnimationFrame = clearTimeout;')
ANSWER_TIMEOUT = 120.0 * PATIENCE  # s
LOOKING_PERIOD = 0.1  # s; each look keeps three processes busy
PAGE_TIMEOUT = 30.0  # s; two processors that draw, simulate and browse take their time
FOLLOW = '[...document.querySelectorAll("label")].find((label) => label.innerText == "follow")?.control'


class Page(webdriver.Chrome):
    """The page in a window of its own Chromium.

    One that drew two pages without a graphics card would make them wait for each other.
    """

    run = webdriver.Chrome.execute_script

    def __init__(self):
        options = webdriver.ChromeOptions()
        options.binary_location = CHROMIUM
        for switch in SWITCHES:
            options.add_argument(switch)
        super().__init__(options=options, service=Service(DRIVER))
        # A browser that draws on a busy processor answers late, to whatever it is asked.
        self.command_executor.client_config.timeout = ANSWER_TIMEOUT
        self.set_page_load_timeout(ANSWER_TIMEOUT)
        self.set_script_timeout(ANSWER_TIMEOUT)
        self.execute_cdp_cmd('Page.addScriptToEvaluateOnNewDocument', {'source': DRAW_SELDOM})

    def open(self, url):
        """Return the page once it has the panel."""
        self.get(url)
        # What each browser has of its own comes after the rest.
        self._wait_until(lambda: self.run(f'return !!document.getElementById("readings") && !!{FOLLOW}'),
                         'a page with readings, and a box of its own')
        return self

    @contextlib.contextmanager
    def resized(self, metrics):
        """Give the window another size for a while; see Emulation.setDeviceMetricsOverride."""
        self.execute_cdp_cmd('Emulation.setDeviceMetricsOverride', metrics)
        yield
        self.execute_cdp_cmd('Emulation.clearDeviceMetricsOverride', {})

    @property
    def text(self):
        return self.run('return document.body.innerText')

    def reading(self, name):
        """Return a number of the panel by its id; None if it is not there."""
        text = self.run('return document.getElementById(arguments[0])?.textContent', name)
        return float(re.match('-?[0-9.]+', text)[0]) if text is not None else None

    def wait_for_reading(self, name, accepts, timeout=PAGE_TIMEOUT):
        def accepted():
            value = self.reading(name)
            return value is not None and accepts(value)
        self._wait_until(accepted, lambda: f'{name}; it is {self.reading(name)}', timeout)

    def wait_for_text(self, text):
        self._wait_until(lambda: text in self.text,
                         lambda: f'{text!r} in the page, which says:\n{self.text}')

    def click(self, label):
        self._button(label).click()

    def follow(self):
        """Have the page follow the robot; one that is opened late shows all."""
        self.run(f'const box = {FOLLOW}; if (!box.checked) box.click()')

    @property
    def follows(self):
        """Whether the page follows the robot."""
        return self.run(f'return {FOLLOW}.checked')

    def box(self, label):
        """Return left, top, width and height of a button (CSS pixels)."""
        return self.run('const box = arguments[0].getBoundingClientRect();'
                        'return [box.left, box.top, box.width, box.height]', self._button(label))

    def hold(self, label):
        ActionChains(self, duration=0).click_and_hold(self._button(label)).perform()

    def press_key(self, name):
        ActionChains(self, duration=0).key_down(getattr(Keys, name)).perform()

    def let_go(self):
        """Release the button or the key."""
        ActionChains(self).reset_actions()

    def dismiss_notices(self):
        """Close what viser says, for instance of the lack of a graphics card."""
        self.run('document.querySelectorAll("[class*=Notification-closeButton]")'
                 '.forEach((button) => button.click())')
        self._wait_until(lambda: not self.run(
            'return document.querySelector("[class*=Notification-root]")'),
            'a page without notices')

    def scene(self):
        """Return the pixels of the 3-D scene between the panels: rows, columns, colours."""
        box = self.run('const box = document.querySelector("canvas").getBoundingClientRect();'
                       'return [box.left, box.top, box.right, box.bottom]'
                       '.map((edge) => edge * devicePixelRatio)')
        picture = Image.open(io.BytesIO(self.get_screenshot_as_png())).convert('RGB')
        return numpy.asarray(picture.crop([round(edge) for edge in box]), dtype=int)

    def count_pixels(self, more, less):
        """Return how many pixels of the scene have clearly more of one colour (0 to 2) than of another."""
        colours = numpy.moveaxis(self.scene(), 2, 0)
        return (colours[more] - colours[less] > 50).sum()

    def _button(self, label):
        # At once in the page: it may replace its buttons at any time.
        return self._wait_until(lambda: self.run(
            'return [...document.querySelectorAll("button")].find('
            '(button) => button.innerText.trim() === arguments[0])', label), f'a button {label!r}')

    @staticmethod
    def _wait_until(condition, what, timeout=PAGE_TIMEOUT):
        return wait_until(condition, timeout, what, LOOKING_PERIOD)
