// Presses and releases the pad's buttons with the arrow keys, and lets go of all at a click on stop.
if (!window.arrowKeys) {
  window.arrowKeys = {ArrowUp: 'forward', ArrowDown: 'back', ArrowLeft: 'left', ArrowRight: 'right'};
  const label = (button) => button?.textContent.trim();
  const pad = () => [...document.querySelectorAll('button')].filter(
    (candidate) => Object.values(window.arrowKeys).includes(label(candidate)));
  const held = new Map();  // arrows by the keys' codes: with Shift a numpad's keys are digits
  const code = (event) => event.code || event.key;  // a phone's keyboard has no codes
  const button = (arrow) => pad().find((candidate) => label(candidate) === window.arrowKeys[arrow]);
  const pointer = (target, kind) => target?.dispatchEvent(
    new PointerEvent(kind, {bubbles: true, button: 0}));
  let next = 0;  // ms, when a release may be sent
  const release = (key) => {
    const arrow = held.get(key);
    if (!held.delete(key) || [...held.values()].includes(arrow)) return;
    pointer(button(arrow), 'pointerup');
    const send = () => {
      if (![...held.values()].includes(arrow)) button(arrow)?.click();
    };
    // viser sends only the latest message of 50 ms.
    const wait = next - performance.now();
    next = Math.max(next, performance.now()) + 60;
    if (wait > 0) setTimeout(send, wait);
    else send();
  };
  const releaseAll = () => [...held.keys()].forEach(release);
  window.addEventListener('keydown', (event) => {
    // While Meta is down, macOS tells no browser of a key that is released.
    if (event.metaKey || event.ctrlKey || event.altKey) return releaseAll();
    // A checkbox and a closed list keep the focus after a click.
    const idle = '[type=range], [type=checkbox], [aria-haspopup=listbox]:not([aria-expanded=true])';
    const typing = event.target.closest?.(`input:not(${idle}), textarea, [role=slider]`);
    if (!(event.key in window.arrowKeys) || typing) return;
    event.preventDefault();
    event.stopPropagation();
    if (held.has(code(event))) return;
    held.set(code(event), event.key);
    pointer(button(event.key), 'pointerdown');
  }, true);
  window.addEventListener('keyup', (event) => release(code(event)), true);
  window.addEventListener('blur', releaseAll);
  document.addEventListener('visibilitychange', releaseAll);
  // A hold within the 50 ms would replace the click on stop.
  window.addEventListener('click', (event) => {
    if (label(event.target.closest?.('button')) === 'stop')
      pad().forEach((target) => pointer(target, 'pointerup'));
  }, true);
  // After a long touch there is no click, with which viser would send the release.
  for (const kind of ['pointerup', 'pointercancel'])
    window.addEventListener(kind, (event) => {
      const target = event.target.closest?.('button');
      if (event.isTrusted && event.pointerType !== 'mouse' && pad().includes(target)) target.click();
    }, true);
}
