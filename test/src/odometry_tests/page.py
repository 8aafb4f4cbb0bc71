"""The page of the browser window in a Chromium, as a user sees and touches it."""

import contextlib
import io
import re

import numpy
import psutil
from PIL import Image
from selenium.webdriver import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

from odometry_tests.linux import command_line
from odometry_tests.waiting import wait_until

LOOKING_PERIOD = 0.1  # s; each look keeps three processes busy
PAGE_TIMEOUT = 30.0  # s; two processors that draw, simulate and browse take their time
SENDING_PERIOD = 50  # ms; viser's page sends only the last change in it, of all inputs together


class Page:
    """A window with the page."""

    def __init__(self, driver, url, frame_rate=None):
        """Take over a driver that shows nothing yet."""
        self.driver = driver
        self.url = url
        self.is_open = True
        self._frame_rate = frame_rate

    def load(self):
        """Show the page and return once it has the panel."""
        # In a window of its own: without its first, empty one Chromium would end with the page.
        self.driver.switch_to.new_window('window')
        if self._frame_rate:
            self.driver.execute_cdp_cmd('Page.addScriptToEvaluateOnNewDocument',
                                        {'source': _draw_at(self._frame_rate)})
        self.driver.get(self.url)
        self._wait_until(lambda: self.run('return !!document.getElementById("readings")'),
                         'a page with readings')

    def __enter__(self):
        """Use it as a context, at whose end the window is closed."""
        return self

    def __exit__(self, *_):
        """Close the window unless it is closed already."""
        self.close()

    def close(self):
        """Close the window, as a user does."""
        if self.is_open:
            self.is_open = False
            self.driver.close()
            self.driver.switch_to.window(self.driver.window_handles[0])

    def run(self, script):
        """Return what a piece of JavaScript returns."""
        return self.driver.execute_script(script)

    @property
    def text(self):
        """All text that is to be read."""
        return self.run('return document.body.innerText')

    def reading(self, name):
        """Return a number of the panel by its id; None if it is a dash or not there yet."""
        text = self.run(f'return document.getElementById("{name}")?.textContent')
        return float(re.match('-?[0-9.]+', text)[0]) if text not in (None, '–') else None

    def wait_for_reading(self, name, accepts, timeout=PAGE_TIMEOUT):
        """Return a number of the panel once it is there and is accepted."""
        def accepted():
            value = self.reading(name)
            return value is not None and accepts(value)
        self._wait_until(accepted, lambda: f'{name}; it is {self.reading(name)}', timeout)
        return self.reading(name)

    def wait_for_text(self, text, timeout=PAGE_TIMEOUT):
        """Return once the text is to be read."""
        self._wait_until(lambda: text in self.text,
                         lambda: f'{text!r} in the page, which says:\n{self.text}', timeout)

    def click(self, label):
        """Click a button."""
        self._button(label).click()

    def type(self, label, text):
        """Type into an input, in place of what it says."""
        field = self._wait_until(lambda: self.driver.find_elements(
            By.XPATH, f'//label[.="{label}"]/following::input'), f'an input {label!r}')[0]
        self._wait_until(field.is_displayed, f'{label!r} in sight')
        field.send_keys(Keys.CONTROL, 'a')
        field.send_keys(text)
        # Its timers end in the order in which they were set: what was typed has been sent by then.
        self.driver.execute_async_script(f'setTimeout(arguments[0], {SENDING_PERIOD})')

    def unfold(self, label):
        """Open a folder by its heading."""
        headings = self._wait_until(lambda: self.driver.find_elements(
            By.XPATH, f'//div[text()="{label}"]'), f'a folder {label!r}')
        headings[0].click()

    def hold(self, label):
        """Press a button and hold it."""
        ActionChains(self.driver, duration=0).click_and_hold(self._button(label)).perform()

    def release(self):
        """Let go of the button."""
        ActionChains(self.driver, duration=0).release().perform()

    def press_key(self, name):
        """Press a key and hold it."""
        ActionChains(self.driver, duration=0).key_down(getattr(Keys, name)).perform()

    def release_key(self, name):
        """Let go of the key."""
        ActionChains(self.driver, duration=0).key_up(getattr(Keys, name)).perform()

    @contextlib.contextmanager
    def hanging(self):
        """Use it as a context in which the page does nothing and answers nobody."""
        driver = psutil.Process(self.driver.service.process.pid)
        renderers = [child for child in driver.children(recursive=True)
                     if '--type=renderer' in command_line(child.pid)]
        assert renderers, 'no process draws the page'
        for renderer in renderers:
            renderer.suspend()
        try:
            yield
        finally:
            for renderer in renderers:
                renderer.resume()

    def let_go(self):
        """Let go of all buttons and keys."""
        ActionChains(self.driver).reset_actions()

    def choose(self, label, option):
        """Choose an option of a list."""
        lists = self._wait_until(lambda: self.driver.find_elements(
            By.XPATH, f'//label[.="{label}"]/following::input'), f'a list {label!r}')
        lists[0].click()
        self._wait_until(lambda: self._options(option), f'{option!r} in the list')
        self._options(option)[0].click()

    def _options(self, text):
        return [option for option in
                self.driver.find_elements(By.CSS_SELECTOR, '[role=option]')
                if option.text == text]

    def dismiss_notices(self):
        """Close what viser says, for instance of the lack of a graphics card."""
        self.run('document.querySelectorAll("[class*=Notification-closeButton]")'
                 '.forEach((button) => button.click())')
        self._wait_until(lambda: not self.run(
            'return document.querySelector("[class*=Notification-root]")'),
            'a page without notices')

    def photograph(self):
        """Return the whole page as an image."""
        return Image.open(io.BytesIO(self.driver.get_screenshot_as_png())).convert('RGB')

    def scene(self):
        """Return the pixels of the 3-D scene between the panels: rows, columns, colours."""
        box = self.run('const box = document.querySelector("canvas").getBoundingClientRect();'
                       'return [box.left, box.top, box.right, box.bottom]'
                       '.map((edge) => edge * devicePixelRatio)')
        return numpy.asarray(self.photograph().crop([round(edge) for edge in box]), dtype=int)

    def _button(self, label):
        # At once in the page: it may replace its buttons at any time.
        return self._wait_until(lambda: self.driver.execute_script(
            'return [...document.querySelectorAll("button")].find('
            '(button) => button.innerText.trim() === arguments[0])', label), f'a button {label!r}')

    @staticmethod
    def _wait_until(condition, what, timeout=PAGE_TIMEOUT):
        return wait_until(condition, timeout, what, LOOKING_PERIOD)


def _draw_at(frame_rate):
    """Return JavaScript by which a page draws only so many pictures per second (Hz)."""
    # All that wants to draw does so at the same moments, or each would get its own picture.
    script = ('window.requestAnimationFrame = (draw) => setTimeout('
              '() => draw(performance.now()), PERIOD - performance.now() % PERIOD);'
              'window.cancelAnimationFrame = clearTimeout;')
    return script.replace('PERIOD', str(1000 / frame_rate))
