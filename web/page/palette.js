// SPDX-License-Identifier: MIT
// The palette: a list of all commands, filtered while typing. Loaded on first use. The focus stays in the text field, and arrows move
// through the list (ARIA's combobox with a listbox).
import { element, setText } from '../browser/dom.js';
import { keyCap } from '../access/keys.js';
import { tr } from '../languages/language.js';

/** @typedef {import('./commands.js').Command} Command */
/** @typedef {import('./commands.js').Commands} Commands */

const PAGE = 8;

/** @type {Palette | undefined} */
let only;

/** @param {Commands} commands */
export function openPalette(commands) {
  only ??= new Palette(commands);
  only.open();
}

class Palette {
  #dialog = element('palette', HTMLDialogElement);
  #input = element('palette-input', HTMLInputElement);
  #list = element('palette-list');
  /** @type {Command[]} */
  #all = [];
  /** @type {Command[]} */
  #shown = [];
  #chosen = 0;

  /** @param {Commands} commands */
  constructor(commands) {
    this.commands = commands;
    this.#input.addEventListener('input', () => this.#filter());
    this.#dialog.addEventListener('keydown', (event) => this.#key(event));
    this.#list.addEventListener('click', (event) => {
      const row = event.target instanceof Element && event.target.closest('li');
      if (row) this.#run([...this.#list.children].indexOf(row));
    });
    // Clicking the list must not take the focus from the field.
    this.#list.addEventListener('mousedown', (event) => event.preventDefault());
    closeOnBackdrop(this.#dialog);
  }

  open() {
    this.#all = this.commands.all();
    this.#input.value = '';
    this.#filter();
    this.#dialog.showModal();
    this.#list.scrollTop = 0;
    this.#input.focus();
  }

  #filter() {
    const words = this.#input.value.toLowerCase().split(/\s+/).filter(Boolean);
    this.#shown = words.length === 0 ? this.#all : this.#all
      .map((command, index) => ({ command, index, rank: rankOf(command, words) }))
      .filter(({ rank }) => rank > 0)
      .sort((a, b) => b.rank - a.rank || a.index - b.index)
      .map(({ command }) => command);
    this.#list.replaceChildren(...this.#shown.map(rowOf));
    const count = this.#shown.length;
    element('palette-none').hidden = count > 0;
    setText(element('palette-count'), count === 1 ? tr('1 command') : tr('{1} commands', count));
    this.#choose(0);
  }

  /** @param {number} index */
  #choose(index) {
    this.#list.children[this.#chosen]?.setAttribute('aria-selected', 'false');
    this.#chosen = Math.min(Math.max(index, 0), Math.max(this.#shown.length - 1, 0));
    const row = this.#list.children[this.#chosen];
    row?.setAttribute('aria-selected', 'true');
    row?.scrollIntoView({ block: 'nearest' });
    if (row) this.#input.setAttribute('aria-activedescendant', row.id);
    else this.#input.removeAttribute('aria-activedescendant');
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const count = this.#shown.length;
    const again = (event.ctrlKey || event.metaKey) && event.key.toLowerCase() === 'k';
    if (again) this.#dialog.close();
    else if (event.target !== this.#input || event.isComposing || count === 0) return;
    else if (event.key === 'ArrowDown') this.#choose((this.#chosen + 1) % count);
    else if (event.key === 'ArrowUp') this.#choose((this.#chosen + count - 1) % count);
    else if (event.key === 'PageDown') this.#choose(this.#chosen + PAGE);
    else if (event.key === 'PageUp') this.#choose(this.#chosen - PAGE);
    else if (event.key === 'Enter') this.#run(this.#chosen);
    else return;
    event.preventDefault();
  }

  /** @param {number} index */
  #run(index) {
    const command = this.#shown[index];
    if (!command || command.whyNot) return;
    this.#dialog.close(); // first, because the command may open another dialog
    command.run();
  }
}

/** @param {HTMLDialogElement} dialog */
export function closeOnBackdrop(dialog) {
  dialog.addEventListener('click', (event) => { if (event.target === dialog) dialog.close(); });
}

/** @param {Command} command @param {string[]} words  lower case @returns {number} 0: no match */
function rankOf({ title, group }, words) {
  const name = title.toLowerCase();
  const where = `${name} ${tr(group).toLowerCase()}`;
  if (!words.every((word) => where.includes(word))) return 0;
  if (name.startsWith(words[0])) return 3;
  return words.every((word) => ` ${name}`.includes(` ${word}`)) ? 2 : 1;
}

/** @param {Command} command @param {number} index */
function rowOf({ title, group, keys, pressed = [], whyNot }, index) {
  const row = document.createElement('li');
  row.id = `palette-row-${index}`;
  row.setAttribute('role', 'option');
  row.setAttribute('aria-selected', 'false');
  row.setAttribute('aria-disabled', String(Boolean(whyNot)));
  const name = document.createElement('span');
  name.textContent = title;
  const note = document.createElement('small');
  note.textContent = whyNot || tr(group);
  row.append(name, note);
  const key = [...keys, ...pressed][0];
  if (key) row.append(capOf(key));
  return row;
}

/** @param {string} key @returns {HTMLElement} */
export function capOf(key) {
  const cap = document.createElement('kbd');
  cap.textContent = keyCap(key);
  return cap;
}
