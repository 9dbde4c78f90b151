// SPDX-License-Identifier: MIT
// How a lesson sets the page up: which panels are shown, what is locked, and the goal. The address says it
// (?panels=style,search&lock=figure&goal=distance>=8), or a script does. docs/embedding.md documents it.
import { banner } from '../browser/dom.js';
import { sentence } from '../share/address.js';
import { followLanguage, tr } from '../languages/language.js';

/** @typedef {import('../app/app.js').App} App */
/** What is left out stays as it is. @typedef {{panels?: string, lock?: string, goal?: string}} ArrangementOptions */

const NAMES = /** @type {const} */ (['panels', 'lock', 'goal']);

export class Arrangement {
  /** @type {import('./goal.js').GoalBar | null} */
  #bar = null;
  #last = Promise.resolve();

  /** @param {App} app @param {import('./api.js').Gaitsmith} told  hears of the goal */
  constructor(app, told) {
    this.app = app;
    this.told = told;
    told.addEventListener('changed', () => this.#bar?.look());
    followLanguage(() => this.#bar?.look());
  }

  /** What the address wishes for. A wish that cannot be understood is said, and the others are fulfilled. */
  begin() {
    const address = new URLSearchParams(location.search);
    for (const name of NAMES) {
      const value = address.get(name);
      if (value !== null) this.set({ [name]: value }).catch(({ message }) => banner(tr('The address of this page asks for what is not there: {1}', sentence(message))));
    }
  }

  /** @param {ArrangementOptions} options @returns {Promise<void>} rejected with a sentence; then nothing has changed */
  set(options) {
    const done = this.#last.then(() => this.#set(options)); // one after the other
    this.#last = done.catch(() => {});
    return done;
  }

  /** @param {ArrangementOptions} options */
  async #set({ goal, ...shown }) {
    const bar = goal ? new (await import('./goal.js')).GoalBar(this.app, this.told, goal) : null; // throws
    const fault = this.app.arrange(shown);
    if (fault) throw new Error(fault);
    if (goal === undefined) return;
    this.#bar?.close();
    this.#bar = bar;
    bar?.show();
  }
}
