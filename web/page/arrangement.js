// SPDX-License-Identifier: MIT
// How a lesson sets up the page: the shown panels, the locks and the goal. They come from the address
// (?panels=style,search&lock=figure&goal=distance>=8), as does whether Live is on (?live=off), or from a script. docs/embedding.md documents them.
import { banner } from '../browser/dom.js';
import { sentence } from '../share/address.js';
import { followLanguage, tr } from '../languages/language.js';

/** @typedef {import('../app/app.js').App} App */
/** Options that are left out stay as they are. @typedef {{panels?: string, lock?: string, goal?: string, live?: string}} ArrangementOptions */

const NAMES = /** @type {const} */ (['panels', 'lock', 'goal', 'live']);

/** The example that the address asks for: ?open=there-and-back */
export const namedExample = () => new URLSearchParams(location.search).get('open') ?? '';

/** Whether the address sets up the page, as lessons do. */
export function arranged() {
  const address = new URLSearchParams(location.search);
  return NAMES.some((name) => name !== 'live' && address.has(name));
}

/**
 * Whether the address asks for the viewer (?view) or the workbench (?edit), whatever link it holds.
 * @returns {'view' | 'edit' | '' | null}  '': for neither; null: both, or one with a value
 */
export function askedMode() {
  const address = new URLSearchParams(location.search);
  const asked = /** @type {const} */ (['view', 'edit']).filter((mode) => address.has(mode));
  if (!asked.length) return '';
  return asked.length === 1 && !address.get(asked[0]) ? asked[0] : null;
}

export class Arrangement {
  /** @type {import('./goal.js').GoalBar | null} */
  #bar = null;
  #pending = Promise.resolve();

  /** @param {App} app @param {import('./api.js').Gaitsmith} gaitsmith  dispatches the 'goal' events */
  constructor(app, gaitsmith) {
    this.app = app;
    this.gaitsmith = gaitsmith;
    gaitsmith.addEventListener('changed', () => this.#bar?.update());
    followLanguage(() => this.#bar?.update());
  }

  /** Applies the options in the address. Invalid options are reported together and do not stop the others. */
  async begin() {
    const address = new URLSearchParams(location.search);
    /** @type {string[]} */
    const faults = [];
    for (const name of NAMES) {
      const value = address.get(name);
      if (value !== null) await this.set({ [name]: value }).catch(({ message }) => { faults.push(sentence(message)); });
    }
    const example = namedExample();
    if (example && !this.app.commands().some(({ id }) => id === `example/${example}`)
      && !Object.hasOwn((await import('../share/examples.js')).EXAMPLES, example)) {
      faults.push(tr('There is no example “{1}”.', example));
    }
    if (askedMode() === null) faults.push(tr('“view” and “edit” take no value, and exclude each other.'));
    if (faults.length) banner(tr('The address of this page has a mistake: {1}', faults.join(' ')));
  }

  /** @param {ArrangementOptions} options @returns {Promise<void>} rejected with a sentence, and nothing changed, if they are invalid */
  set(options) {
    const done = this.#pending.then(() => this.#set(options)); // one at a time
    this.#pending = done.catch(() => {});
    return done;
  }

  /** @param {ArrangementOptions} options */
  async #set({ goal, ...shown }) {
    const bar = goal ? new (await import('./goal.js')).GoalBar(this.app, this.gaitsmith, goal) : null; // throws
    const fault = this.app.arrange(shown);
    if (fault) throw new Error(fault);
    if (goal === undefined) return;
    this.#bar?.close();
    this.#bar = bar;
    bar?.show();
  }
}
