// Presses and releases the pad's buttons with the arrow keys.
if (!window.arrowKeys) {
  window.arrowKeys = {ArrowUp: 'forward', ArrowDown: 'back', ArrowLeft: 'left', ArrowRight: 'right'};
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
    // A checkbox and a closed list keep the focus after a click.
    const idle = '[type=range], [type=checkbox], [aria-haspopup=listbox]:not([aria-expanded=true])';
    const typing = event.target.closest?.(`input:not(${idle}), textarea, [role=slider]`);
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
