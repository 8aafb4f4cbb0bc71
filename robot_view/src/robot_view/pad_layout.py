"""The HTML of the pad: the layout of its buttons, and the arrow keys.

viser reports that a key goes down, but not that it comes up, so the page itself maps the arrow keys
to presses of the buttons.
"""

import html
import json

from robot_view.steering import BACK, FORWARD, LEFT, RIGHT

ARROW_KEYS = {'ArrowUp': FORWARD, 'ArrowDown': BACK, 'ArrowLeft': LEFT, 'ArrowRight': RIGHT}

SCRIPT = '''
if (!window.arrowKeys) {
  window.arrowKeys = KEYS;
  const held = new Set();
  const button = (key) => [...document.querySelectorAll('button')].find(
    (candidate) => candidate.textContent.trim() === window.arrowKeys[key]);
  const pointer = (key, kind) => button(key)?.dispatchEvent(
    new PointerEvent(kind, {bubbles: true, button: 0}));
  const release = (key) => {
    if (!held.delete(key)) return;
    pointer(key, 'pointerup');
    button(key)?.click();
  };
  const releaseAll = () => [...held].forEach(release);
  window.addEventListener('keydown', (event) => {
    const typing = event.target.closest?.('input:not([type=range]), textarea, [role=slider]');
    if (!(event.key in window.arrowKeys) || typing) return;
    event.preventDefault();
    event.stopPropagation();
    if (held.has(event.key)) return;
    held.add(event.key);
    pointer(event.key, 'pointerdown');
  }, true);
  window.addEventListener('keyup', (event) => release(event.key), true);
  window.addEventListener('blur', releaseAll);
  document.addEventListener('visibilitychange', releaseAll);
}
'''.replace('KEYS', json.dumps(ARROW_KEYS))

STYLE = '''
div:has(> div > #pad) {display: grid; grid-template-columns: repeat(3, 1fr); padding: 0 0.4em}
div:has(> div > #pad) > :nth-child(1), div:has(> div > #pad) > :nth-child(n+7) {grid-column: 1/4}
div:has(> div > #pad) > :nth-child(2), div:has(> div > #pad) > :nth-child(6) {grid-column: 2}
div:has(> div > #pad) > :nth-child(3) {grid-column: 1}
div:has(> div > #pad) > :nth-child(n+2) > button {margin: 0; padding: 0; touch-action: none}
'''

LAYOUT = f'''<style>{STYLE}</style><img id="pad" alt="" src="data:," style="display:none"
onerror="{html.escape(SCRIPT)}">'''
