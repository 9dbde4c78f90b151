// SPDX-License-Identifier: MIT
// The dialog that names a result.
import { element, onClick, setText } from '../browser/dom.js';
import { trSentence } from '../languages/language.js';

/** @typedef {import('../app/app.js').App} App */

export class Naming {
  #dialog = element('name-dialog', HTMLDialogElement);
  #text = element('name-text', HTMLInputElement);
  #error = element('name-error');
  #id = '';

  /** @param {App} app */
  constructor(app) {
    onClick('name-cancel', () => this.#dialog.close());
    this.#dialog.addEventListener('submit', (event) => {
      const fault = app.renameFound(this.#id, this.#text.value.trim());
      setText(this.#error, fault && trSentence(fault));
      if (fault) event.preventDefault();
    });
  }

  /** @param {string} id @param {string} name  the current name, or empty @param {string} placeholder  shown if it is empty */
  ask(id, name, placeholder) {
    this.#id = id;
    this.#text.value = name;
    this.#text.placeholder = placeholder;
    setText(this.#error, '');
    this.#dialog.showModal();
    this.#text.select();
  }
}
