// SPDX-License-Identifier: MIT
// The page's own commands and the application's (shell/session/commands.cpp) in one list. Keys, the list of keys and
// the palette use it.
import { element } from '../browser/dom.js';
import { belongsToControls, keyName } from '../access/keys.js';
import { tr, trLater } from '../languages/language.js';
import { remembered, remember } from '../browser/storage.js';

/** @typedef {import('../app/app.js').App} App */
/** @typedef {import('../access/mirror.js').Mirror} Mirror */
/**
 * @typedef {object} Command
 * @property {string} id
 * @property {string} group        one of GROUPS
 * @property {string} title
 * @property {string[]} keys       names as from keyName
 * @property {string[]} [pressed]  keys that the browser handles, with an event such as 'copy' or 'paste'
 * @property {string} [whyNot]     the reason if it is unavailable
 * @property {() => void} run
 */

// In order. The very first command must be harmless, because Enter runs it in a palette that was opened by mistake.
const GROUPS = [trLater('Motion'), trLater('Search'), trLater('Results'), trLater('Timeline'), trLater('Document'), trLater('Panels'), trLater('World'),
  trLater('View'), trLater('Help'), trLater('Kept work'), trLater('Examples'), trLater('Tasks'), trLater('Figures')];
const SINGLE_KEYS_KEY = 'gaitsmith-single-keys';
const TEXT_FIELDS = 'textarea, input:not([type=radio], [type=checkbox]), [contenteditable]';
const PRESSABLE = 'a, button, summary';
const CHOICES = 'input, select';

export class Commands {
  /** @type {Command[]} */
  #own = [];
  /** @type {(() => Command[])[]} */
  #sources = [];
  #singleKeys = remembered(SINGLE_KEYS_KEY) !== 'off';

  /** @param {App} app @param {Mirror} mirror */
  constructor(app, mirror) {
    this.app = app;
    this.mirror = mirror;
    addEventListener('pointerdown', () => this.#point(true), { capture: true });
    addEventListener('keydown', ({ key }) => { if (/^(Tab|Arrow|F6|Escape)/.test(key)) this.#point(false); }, { capture: true });
  }

  /** Whether the focus was last moved by a pointer, so that no ring shows it. A browser would show one after any key. */
  get #pointed() { return 'pointed' in document.documentElement.dataset; }
  /** @param {boolean} on */
  #point(on) { document.documentElement.toggleAttribute('data-pointed', on); }

  /** @param {Command[]} commands  of the page, with English titles */
  add(commands) { this.#own.push(...commands); }
  /** Adds commands without keys. @param {() => Command[]} source  returns the commands available now */
  addSource(source) { this.#sources.push(source); }

  /** A command's action: clicks the button with this id. @param {string} id @returns {() => void} */
  static click(id) { return () => element(id).click(); }

  /** Runs a command of the page. @param {string} id */
  runOwn(id) { this.#own.find((command) => command.id === id)?.run(); }

  /** All commands, by group. @returns {Command[]} */
  all() {
    const canvas = this.app.commands().map((command) => ({ ...command, run: () => { this.app.run(command.id); } }));
    const own = this.#own.map((command) => ({ ...command, title: tr(command.title) }));
    const place = (/** @type {Command} */ { group }) => GROUPS.indexOf(group);
    return [...canvas, ...own, ...this.#sources.flatMap((source) => source())].sort((a, b) => place(a) - place(b));
  }

  /** Whether keys act without Ctrl. Can be turned off for speech input, and against accidental key presses. */
  get singleKeys() { return this.#singleKeys; }
  set singleKeys(on) {
    this.#singleKeys = on;
    remember(SINGLE_KEYS_KEY, on ? null : 'off');
  }

  /** @param {KeyboardEvent} event @returns {boolean} whether a command handled it */
  handle(event) {
    const { target } = event;
    if (!(target instanceof Element) || event.isComposing || document.querySelector('dialog[open], #breed:not([hidden])')) return false;
    const name = keyName(event);
    const mirrored = this.mirror.contains(target);
    if (mirrored ? this.mirror.keys.wants(target, name) : target.matches(TEXT_FIELDS)) return false;
    if (name.length === 1 && !this.#singleKeys) return false;
    const onCanvas = mirrored || target === this.mirror.canvas;
    // Space plays wherever the mouse last clicked, also on a button.
    const plays = name === 'Space' && this.#pointed;
    if (target.closest(PRESSABLE) && /^(Space|Enter)$/.test(name) && !plays) return false;
    if (!mirrored && target.closest(CHOICES) && belongsToControls(name)) return false;
    const own = this.#own.find(({ keys }) => keys.includes(name));
    // Text input on the canvas comes first.
    if (own && !(onCanvas && name.length === 1 && this.app.typing())) {
      if (!event.repeat) own.run();
      return true;
    }
    return this.app.key(name, onCanvas, event.repeat);
  }
}
