// SPDX-License-Identifier: MIT
// Everything that can be done without pointing at a control: the page's own commands and the application's (its table
// is shell/session/commands.cpp) as one list. Keys, the sheet of keys and the palette all come from it.
import { element } from '../browser/dom.js';
import { belongsToControls, keyName } from '../access/keys.js';
import { tr, trLater } from '../languages/language.js';
import { remembered, remember } from '../browser/storage.js';

/** @typedef {import('../app/app.js').App} App */
/** @typedef {import('../access/mirror.js').Mirror} Mirror */
/**
 * @typedef {object} Command
 * @property {string} id
 * @property {string} group        in English, as GROUPS has it
 * @property {string} title
 * @property {string[]} keys       as keyName gives them
 * @property {string[]} [pressed]  keys that reach it as an event of the browser's own (copy, paste)
 * @property {string} [whyNot]     not possible now, and why
 * @property {() => void} run
 */

// The first of all is what Enter does in a palette opened by mistake, so it had better be harmless.
const GROUPS = [trLater('Motion'), trLater('Search'), trLater('Results'), trLater('Timeline'), trLater('Document'), trLater('Panels'), trLater('View'),
  trLater('Help'), trLater('Kept work'), trLater('Examples'), trLater('Tasks'), trLater('Figures')];
const SINGLE_KEYS = 'gaitsmith-single-keys';
const TEXT = 'textarea, input:not([type=radio], [type=checkbox]), [contenteditable]';
const PRESSED = 'a, button, summary';
const CHOSEN = 'input, select';

export class Commands {
  /** @type {Command[]} */
  #own = [];
  /** @type {(() => Command[])[]} */
  #shelves = [];
  #singleKeys = remembered(SINGLE_KEYS) !== 'off';

  /** @param {App} app @param {Mirror} mirror */
  constructor(app, mirror) {
    this.app = app;
    this.mirror = mirror;
  }

  /** @param {Command[]} commands  of the page, their titles in English */
  add(commands) { this.#own.push(...commands); }
  /** Commands without keys that come and go. @param {() => Command[]} source  asked whenever the list is wanted */
  addShelf(source) { this.#shelves.push(source); }

  /** A click on the button with this id does it. @param {string} id @returns {() => void} */
  static click(id) { return () => element(id).click(); }

  /** All that there are now, group by group. @returns {Command[]} */
  all() {
    const canvas = this.app.commands().map((command) => ({ ...command, run: () => { this.app.run(command.id); } }));
    const own = this.#own.map((command) => ({ ...command, title: tr(command.title) }));
    const place = (/** @type {Command} */ { group }) => GROUPS.indexOf(group);
    return [...canvas, ...own, ...this.#shelves.flatMap((source) => source())].sort((a, b) => place(a) - place(b));
  }

  /** Keys that are characters act without Ctrl. Who speaks to the machine, or rests a hand on it, may turn them off. */
  get singleKeys() { return this.#singleKeys; }
  set singleKeys(on) {
    this.#singleKeys = on;
    remember(SINGLE_KEYS, on ? null : 'off');
  }

  /** @param {KeyboardEvent} event @returns {boolean} whether a command took it */
  take(event) {
    const { target } = event;
    if (!(target instanceof Element) || event.isComposing || document.querySelector('dialog[open]')) return false;
    const name = keyName(event);
    const mirrored = this.mirror.contains(target);
    if (mirrored ? this.mirror.keys.wants(target, name) : target.matches(TEXT)) return false;
    if (name.length === 1 && !this.#singleKeys) return false;
    const onCanvas = mirrored || target === this.mirror.canvas;
    if (target.closest(PRESSED) && /^(Space|Enter)$/.test(name)) return false;
    if (!mirrored && target.closest(CHOSEN) && belongsToControls(name)) return false;
    const own = this.#own.find(({ keys }) => keys.includes(name));
    // Whatever is being typed on the canvas comes first.
    if (own && !(onCanvas && name.length === 1 && this.app.typing())) {
      if (!event.repeat) own.run();
      return true;
    }
    return this.app.key(name, onCanvas, event.repeat);
  }
}
