// SPDX-License-Identifier: MIT
// The list of keys: every command with a key, by group. Loaded on first use.
import { element } from '../browser/dom.js';
import { tr } from '../languages/language.js';
import { capOf, closeOnBackdrop } from './palette.js';

/** @typedef {import('./commands.js').Command} Command */
/** @typedef {import('./commands.js').Commands} Commands */

/** @type {HelpSheet | undefined} */
let only;

/** @param {Commands} commands */
export function openHelp(commands) {
  only ??= new HelpSheet(commands);
  only.open();
}

class HelpSheet {
  #dialog = element('help', HTMLDialogElement);
  #single = element('help-single', HTMLInputElement);

  /** @param {Commands} commands */
  constructor(commands) {
    this.commands = commands;
    this.#single.addEventListener('change', () => { commands.singleKeys = this.#single.checked; });
    closeOnBackdrop(this.#dialog);
  }

  open() {
    this.#single.checked = this.commands.singleKeys;
    /** @type {Map<string, Command[]>} */
    const groups = new Map();
    for (const command of this.commands.all()) {
      if (command.keys.length + (command.pressed?.length ?? 0) === 0) continue;
      groups.set(command.group, [...groups.get(command.group) ?? [], command]);
    }
    element('help-groups').replaceChildren(...[...groups].map(([name, commands]) => sectionOf(name, commands)));
    this.#dialog.showModal();
  }
}

/** @param {string} name @param {Command[]} commands */
function sectionOf(name, commands) {
  const section = document.createElement('section');
  const heading = document.createElement('h3');
  heading.textContent = tr(name);
  const list = document.createElement('dl');
  for (const { title, keys, pressed = [] } of commands) {
    const row = document.createElement('div');
    const what = document.createElement('dt');
    what.textContent = title;
    const which = document.createElement('dd');
    which.append(...[...keys, ...pressed].map(capOf));
    row.append(what, which);
    list.append(row);
  }
  section.append(heading, list);
  return section;
}
