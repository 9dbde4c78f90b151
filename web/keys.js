// SPDX-License-Identifier: MIT
// Keys that belong to the browser or to the page, not to the canvas. SDL prevents the default of every key it gets
// with Ctrl, so it must not get these: the guard sees them first.

const WITH_CONTROL = new Set(['c', 'x', 'v', '+', '-', '=', '0', 'r', 'l', 't', 'w', 'n', 'p', 'f', 's', 'o', 'Tab', 'F5']);
const ALONE = new Set(['F1', 'F3', 'F5', 'F6', 'F7', 'F10', 'F11', 'F12']);

export function guardKeys() {
  for (const type of /** @type {const} */ (['keydown', 'keyup', 'keypress'])) {
    addEventListener(type, (event) => {
      const control = event.ctrlKey || event.metaKey;
      const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
      if (control ? WITH_CONTROL.has(key) : ALONE.has(key) || event.altKey) event.stopImmediatePropagation();
    }, { capture: true });
  }
}

/**
 * Moves the keyboard from the canvas to its neighbour in the page.
 * @param {HTMLCanvasElement} canvas
 * @param {number} direction  1 forwards, -1 backwards, 0 just away
 */
export function leaveCanvas(canvas, direction) {
  const all = [...document.querySelectorAll('a[href], button, input, textarea, canvas')].filter((node) =>
    node instanceof HTMLElement && !node.matches(':disabled') && node.getClientRects().length > 0 && !node.closest('dialog:not([open])'));
  const next = direction === 0 ? undefined : all[(all.indexOf(canvas) + direction + all.length) % all.length];
  if (next instanceof HTMLElement) next.focus();
  else canvas.blur();
}
