// SPDX-License-Identifier: MIT
// The dialog in which a found motion gets a name.
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

  /** @param {string} id @param {string} name  the present one, or empty @param {string} usual  what stands there then */
  ask(id, name, usual) {
    this.#id = id;
    this.#text.value = name;
    this.#text.placeholder = usual;
    setText(this.#error, '');
    this.#dialog.showModal();
    this.#text.select();
  }
}
