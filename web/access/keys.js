// SPDX-License-Identifier: MIT
// The names of keys, and whether commands, the browser or the canvas receive them.
import { tr, trLater } from '../languages/language.js';

// Keys of the browser or the page, not of the canvas. SDL prevents the default action of every key that it receives
// with Ctrl, so guardKeys() stops these before they reach SDL.
const WITH_CONTROL = new Set(['c', 'x', 'v', '+', '-', '=', '0', 'r', 'l', 't', 'w', 'n', 'p', 'f', 's', 'o', 'Tab', 'F5']);
const ALONE = new Set(['F1', 'F3', 'F5', 'F6', 'F7', 'F10', 'F11', 'F12']);

/**
 * Such as "Space", "s", "?", "Home", "Ctrl+Shift+z". Ctrl also means ⌘. Shift is omitted if it changes the character.
 * @param {KeyboardEvent} event
 */
export function keyName(event) {
  const typed = event.getModifierState('AltGraph'); // which some systems report as Ctrl and Alt
  let name = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (name === ' ') name = 'Space';
  // On keyboards without Latin letters, the position of the key decides.
  if (name.length === 1 && name > '~') name = /^Key([A-Z])$/.exec(event.code)?.[1].toLowerCase() ?? name;
  if (event.shiftKey && (name.length > 1 || /[a-z]/.test(name))) name = `Shift+${name}`;
  if (!typed && (event.ctrlKey || event.metaKey)) name = `Ctrl+${name}`;
  return event.altKey && !typed ? `Alt+${name}` : name;
}

/** Keys whose labels are words. */
const PRINTED = [trLater('Ctrl'), trLater('Shift'), trLater('Space'), trLater('Home'), trLater('End')];

/** The label of a key on the keyboard. @param {string} name  as from keyName */
export function keyCap(name) {
  const mac = /Mac|iPhone|iPad/.test(navigator.platform);
  const caps = /** @type {Record<string, string>} */ ({ ...mac && { Ctrl: '⌘', Shift: '⇧' }, ArrowLeft: '←', ArrowRight: '→' });
  return name.split('+').map((part) => caps[part] ?? (PRINTED.includes(part) ? tr(part) : part.length === 1 ? part.toUpperCase() : part)).join(mac ? '' : '+');
}

/** Whether a focused control may need this key. @param {string} name */
export function belongsToControls(name) { return /^(Space|Enter|Home|End|Arrow.*)$/.test(name); }

/** @param {(event: KeyboardEvent) => boolean} handle  runs a command; returns false if the key has none */
export function guardKeys(handle) {
  /** Keys that a command handled and that are still held. Firefox presses a focused button when Space is released. @type {Set<string>} */
  const handled = new Set();
  for (const type of /** @type {const} */ (['keydown', 'keyup', 'keypress'])) {
    addEventListener(type, (event) => {
      const taken = type === 'keydown' ? handle(event) : type === 'keyup' && handled.has(event.code);
      if (taken) {
        if (type === 'keydown') handled.add(event.code); else handled.delete(event.code);
        event.preventDefault();
        event.stopImmediatePropagation();
        return;
      }
      const control = event.ctrlKey || event.metaKey;
      const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
      if (control ? WITH_CONTROL.has(key) : ALONE.has(key) || event.altKey) event.stopImmediatePropagation();
    }, { capture: true });
  }
}
