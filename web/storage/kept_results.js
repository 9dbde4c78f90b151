// SPDX-License-Identifier: MIT
// Found motions that this browser keeps, so that a reload does not lose them: the application says what changes, one
// entry each, so that two tabs never write over each other's. What an entry holds is the application's concern.
import { tr } from '../languages/language.js';
import { remember, remembered, rememberedKeys } from '../browser/storage.js';

/** @typedef {import('../app/app.js').App} App */

const PREFIX = 'gaitsmith-found/';

export class KeptResults {
  // Pages inside other pages keep nothing.
  #keeps = window.top === window;
  #told = false;

  /** @param {import('../access/status_line.js').StatusLine} statusLine */
  constructor(statusLine) {
    this.statusLine = statusLine;
  }

  /** Gives the application what earlier visits kept. @param {App} app */
  restore(app) {
    if (!this.#keeps) return;
    // What is not understood is left alone: it may be of a newer page.
    for (const key of rememberedKeys(PREFIX)) {
      const text = remembered(key) ?? '';
      const id = app.restoreFound(text);
      // An earlier page had another idea of what is the same motion.
      if (id === '' || key === PREFIX + id) continue;
      if (remembered(PREFIX + id) === null) remember(PREFIX + id, text);
      remember(key, null);
    }
  }

  /** @param {string} id @param {string} text  empty: forget it */
  store(id, text) {
    if (!this.#keeps || remember(PREFIX + id, text || null) || !text || this.#told) return;
    this.#told = true;
    // After the words about the search that has found it.
    setTimeout(() => this.statusLine.say(tr(
      'This browser has no room for more results, or does not let the page keep them: they are here until you leave.')));
  }
}
