// SPDX-License-Identifier: MIT
// Decides when to offer the tour of the playground, and loads it only then.
import { tr } from '../languages/language.js';
import { remember, remembered } from '../browser/storage.js';

/** @typedef {import('../app/app.js').App} App */
/** @typedef {import('./tour.js').Tour} Tour */

const KEY = 'gaitsmith-tour';

export class Guide {
  /** @type {Promise<Tour> | null} */
  #tour = null;

  /** @param {App} app @param {HTMLCanvasElement} canvas @param {import('../access/status_line.js').StatusLine} statusLine */
  constructor(app, canvas, statusLine) {
    this.app = app;
    this.canvas = canvas;
    this.statusLine = statusLine;
  }

  /** Starts the tour on a first visit whose address opens nothing. */
  offer() {
    if (window.top !== window || location.hash.length > 1 || remembered(KEY)) return;
    // Without storage the tour would start at every visit.
    if (remember(KEY, 'offered')) void this.start();
  }

  async start() {
    this.#tour ??= import('./tour.js').then(({ Tour }) => new Tour(this.app, this.canvas));
    try {
      (await this.#tour).start();
    } catch {
      this.#tour = null; // try again next time
      this.statusLine.say(tr('The tour could not be loaded.'));
    }
  }
}
