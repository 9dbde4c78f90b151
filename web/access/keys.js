// SPDX-License-Identifier: MIT
// Keys: their names, and who gets them.
import { tr, trLater } from '../languages/language.js';

// Those that belong to the browser or to the page, not to the canvas. SDL prevents the default of every key it gets
// with Ctrl, so it must not get these: the guard sees them first.
const WITH_CONTROL = new Set(['c', 'x', 'v', '+', '-', '=', '0', 'r', 'l', 't', 'w', 'n', 'p', 'f', 's', 'o', 'Tab', 'F5']);
const ALONE = new Set(['F1', 'F3', 'F5', 'F6', 'F7', 'F10', 'F11', 'F12']);

/**
 * Like "Space", "s", "?", "Home", "Ctrl+Shift+z". Ctrl stands for ⌘, too; Shift is named only where it does not make
 * another character.
 * @param {KeyboardEvent} event
 */
export function keyName(event) {
  const typed = event.getModifierState('AltGraph'); // which some systems report as Ctrl and Alt
  let name = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (name === ' ') name = 'Space';
  // Where letters are not Latin ones, the place of the key decides.
  if (name.length === 1 && name > '~') name = /^Key([A-Z])$/.exec(event.code)?.[1].toLowerCase() ?? name;
  if (event.shiftKey && (name.length > 1 || /[a-z]/.test(name))) name = `Shift+${name}`;
  if (!typed && (event.ctrlKey || event.metaKey)) name = `Ctrl+${name}`;
  return event.altKey && !typed ? `Alt+${name}` : name;
}

/** Those with words on them. */
const PRINTED = [trLater('Ctrl'), trLater('Shift'), trLater('Space'), trLater('Home'), trLater('End')];

/** A key as it is printed on the keyboard. @param {string} name  as of keyName */
export function keyCap(name) {
  const mac = /Mac|iPhone|iPad/.test(navigator.platform);
  const caps = /** @type {Record<string, string>} */ ({ ...mac && { Ctrl: '⌘', Shift: '⇧' }, ArrowLeft: '←', ArrowRight: '→' });
  return name.split('+').map((part) => caps[part] ?? (PRINTED.includes(part) ? tr(part) : part.length === 1 ? part.toUpperCase() : part)).join(mac ? '' : '+');
}

/** A key that a focused control may want for itself. @param {string} name */
export function belongsToControls(name) { return /^(Space|Enter|Home|End|Arrow.*)$/.test(name); }

/** @param {(event: KeyboardEvent) => boolean} take  commands come first; true: this was one */
export function guardKeys(take) {
  for (const type of /** @type {const} */ (['keydown', 'keyup', 'keypress'])) {
    addEventListener(type, (event) => {
      if (type === 'keydown' && take(event)) {
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
