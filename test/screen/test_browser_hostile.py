"""Another page in the same browser, as any tab on the internet: it does not get at the robots."""

import contextlib
import http.server
import threading

import pytest

viser = pytest.importorskip('viser', reason='viser is not installed')

# The element is what a Browser waits for when it opens a page.
HOSTILE_PAGE = '''<!DOCTYPE html><title>Win a robot</title><p id="readings"></p><script>
const note = (word) => { document.getElementById('readings').textContent += word + ' '; };
for (const name of ['localhost', '127.0.0.1']) {
  const socket = new WebSocket(`ws://${name}:PORT`, ['viser-vVERSION']);
  let isOpen = false;
  socket.onopen = () => { isOpen = true; note('connected'); };
  socket.onclose = () => { if (!isOpen) note('refused'); };
}
</script>'''


@contextlib.contextmanager
def hostile_page(view):
    """Serve a page that connects to a viewer's websocket; yield where it is."""
    port = view.url.rpartition(':')[2]
    text = HOSTILE_PAGE.replace('PORT', port).replace('VERSION', viser.__version__)

    class Handler(http.server.BaseHTTPRequestHandler):
        def do_GET(self):
            self.send_response(200)
            self.send_header('Content-Type', 'text/html')
            self.end_headers()
            self.wfile.write(text.encode())

        def log_message(self, *_):
            pass

    with http.server.ThreadingHTTPServer(('localhost', 0), Handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f'http://localhost:{server.server_address[1]}'
        server.shutdown()


def test_a_page_of_another_origin_gets_no_connection(browser, view, page):
    """While the page itself is open beside it, and stays so."""
    with hostile_page(view) as url, browser.open(url) as hostile:
        hostile.wait_for_text('refused refused')
        assert 'connected' not in hostile.text
        view.process.wait_for_output(f'Origin header is "{url}"')
    page.wait_for_text('waiting for odometry')
