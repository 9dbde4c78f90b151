// SPDX-License-Identifier: MIT
// Found motions in the browser's storage, which survive a reload. The application reports every change. Each motion has
// its own entry, so that tabs do not overwrite each other's. Only the application knows the format of an entry.
import { tr } from '../languages/language.js';
import { remember, remembered, rememberedKeys } from '../browser/storage.js';

/** @typedef {import('../app/app.js').App} App */

const PREFIX = 'gaitsmith-found/';

export class KeptResults {
  // Pages inside other pages store nothing.
  #enabled = window.top === window;
  #warned = false;

  /** @param {import('../access/status_line.js').StatusLine} statusLine */
  constructor(statusLine) {
    this.statusLine = statusLine;
  }

  /** Passes the stored motions to the application. @param {App} app */
  restore(app) {
    if (!this.#enabled) return;
    // Invalid entries stay, because a newer version of the page may have written them.
    for (const key of rememberedKeys(PREFIX)) {
      const text = remembered(key) ?? '';
      const id = app.restoreFound(text);
      // An earlier version of the page computed ids in another way.
      if (id === '' || key === PREFIX + id) continue;
      if (remembered(PREFIX + id) === null) remember(PREFIX + id, text);
      remember(key, null);
    }
  }

  /** @param {string} id @param {string} text  empty: removes the entry */
  store(id, text) {
    if (!this.#enabled || remember(PREFIX + id, text || null) || !text || this.#warned) return;
    this.#warned = true;
    // Later, so that the search's own sentence does not replace this one.
    setTimeout(() => this.statusLine.say(tr(
      'This browser has no room for more results, or does not let the page keep them. They stay until you leave the page.')));
  }
}
