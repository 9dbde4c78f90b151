// SPDX-License-Identifier: MIT
// Loads the tour of the playground when a person asks for it.
import { tr } from '../languages/language.js';

/** @typedef {import('../app/app.js').App} App */
/** @typedef {import('./tour.js').Tour} Tour */

export class Guide {
  /** @type {Promise<Tour> | null} */
  #tour = null;

  /** @param {App} app @param {HTMLCanvasElement} canvas @param {import('../access/status_line.js').StatusLine} statusLine */
  constructor(app, canvas, statusLine) {
    this.app = app;
    this.canvas = canvas;
    this.statusLine = statusLine;
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
