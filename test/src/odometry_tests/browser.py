"""A headless Chromium that looks at the browser window, as a user does."""

import shutil

from selenium import webdriver
from selenium.webdriver.chrome.service import Service

from odometry_tests.page import Page
from odometry_tests.waiting import PATIENCE

CHROMIUM, DRIVER = shutil.which('chromium'), shutil.which('chromedriver')
# Without a graphics card Chromium draws with the processor, if it is told that it may.
SWITCHES = ['--headless=new', '--no-sandbox', '--disable-dev-shm-usage', '--use-gl=angle',
            '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-gpu-compositing',
            # A window that no other one covers is still hidden to Chromium.
            '--disable-backgrounding-occluded-windows', '--disable-renderer-backgrounding']

ANSWER_TIMEOUT = 120.0 * PATIENCE  # s


class Browser:
    """A context in which pages can be opened, each by a Chromium of its own.

    One that drew two pages without a graphics card would make them wait for each other.
    """

    def __init__(self, width=1200, height=640, scale=1.0, frame_rate=None):
        """Take the size of its windows (pixels of the page).

        :param scale: pixels of the screen per pixel of the page; the fewer, the less work
        :param frame_rate: at most so many pictures per second (Hz), for a machine that has other
            things to do; None: as many as it can draw
        """
        self._switches = [*SWITCHES, f'--window-size={width},{height}',
                          f'--force-device-scale-factor={scale}']
        self._frame_rate = frame_rate
        self._pages = []
        self._drivers = []

    def __enter__(self):
        """Use it as a context."""
        return self

    def __exit__(self, *_):
        """End all."""
        for driver in self._drivers:
            driver.quit()

    def open(self, url):
        """Open a page and return it once it shows the panel."""
        page = Page(self._idle_driver() or self._start(), url, self._frame_rate)
        self._pages.append(page)
        page.load()
        return page

    def find(self, url):
        """Return a page at this address that is still open, or None."""
        return next((page for page in self._pages if page.url == url and page.is_open), None)

    def _idle_driver(self):
        """Return a Chromium whose page has been closed, or None: to start one takes longer."""
        busy = [page.driver for page in self._pages if page.is_open]
        return next((driver for driver in self._drivers if driver not in busy), None)

    def _start(self):
        """Start a Chromium."""
        options = webdriver.ChromeOptions()
        options.binary_location = CHROMIUM
        for switch in self._switches:
            options.add_argument(switch)
        driver = webdriver.Chrome(options=options, service=Service(DRIVER))
        self._drivers.append(driver)
        # A browser that draws on a busy processor answers late, to whatever it is asked.
        driver.command_executor.client_config.timeout = ANSWER_TIMEOUT
        driver.set_page_load_timeout(ANSWER_TIMEOUT)
        driver.set_script_timeout(ANSWER_TIMEOUT)
        return driver
