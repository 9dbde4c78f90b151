// SPDX-License-Identifier: MIT
// The dialog that names a result. Loaded on first use.
import { element, onClick, setText } from '../browser/dom.js';
import { trSentence } from '../languages/language.js';

/** @typedef {import('../app/app.js').App} App */

/** @type {Naming | undefined} */
let only;

/** @param {App} app @param {string} id @param {string} name  the current name, or empty @param {string} usual  shown if it is empty */
export function askName(app, id, name, usual) {
  only ??= new Naming(app);
  only.ask(id, name, usual);
}

class Naming {
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
