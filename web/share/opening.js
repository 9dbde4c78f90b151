// SPDX-License-Identifier: MIT
// The Open dialog: the shipped motions, files and links. Loaded on first use.
import { Gallery } from './gallery.js';
import { element, onClick } from '../browser/dom.js';
import { sentence } from './address.js';
import { textOf } from './file_text.js';
import { tr, trTitle } from '../languages/language.js';

/** @typedef {import('../app/app.js').App} App */
/** @typedef {import('../access/status_line.js').StatusLine} StatusLine */

/** @type {OpenDialog | undefined} */
let only;

/** @param {App} app @param {StatusLine} statusLine */
export function openOpen(app, statusLine) {
  only ??= new OpenDialog(app, statusLine);
  only.show();
}

class OpenDialog {
  #dialog = element('open-dialog', HTMLDialogElement);
  #text = element('open-text', HTMLTextAreaElement);
  #file = element('file', HTMLInputElement);
  #error = element('open-error');
  #gallery = new Gallery(({ title, link }) => {
    if (this.#open(link)) this.statusLine.say(tr('Opened {1}. Undo restores the previous version.', trTitle(title)));
  });

  /** @param {App} app @param {StatusLine} statusLine */
  constructor(app, statusLine) {
    this.app = app;
    this.statusLine = statusLine;
    onClick('open-go', () => this.#open(this.#text.value));
    onClick('open-file', () => this.#file.click());
    this.#file.addEventListener('change', () => void this.#chosen());
    this.#text.addEventListener('keydown', (event) => {
      if (event.key !== 'Enter' || event.shiftKey || event.isComposing) return;
      event.preventDefault();
      this.#open(this.#text.value);
    });
    // What is pasted anywhere in the dialog is opened.
    this.#dialog.addEventListener('paste', (event) => {
      event.preventDefault();
      this.#text.value = event.clipboardData?.getData('text/plain') ?? '';
      this.#open(this.#text.value);
    });
    this.#dialog.addEventListener('close', () => this.#closed());
  }

  show() {
    this.#text.value = '';
    this.#error.textContent = '';
    this.#dialog.showModal();
    const begin = element('open-file'); // not the text, which would bring up a phone's keyboard
    begin.focus();
    const none = element('open-none');
    none.hidden = true;
    this.#gallery.show().then(() => {
      if (document.activeElement === begin) this.#gallery.focus();
    }, () => { none.hidden = false; });
  }

  /** @param {string} content @returns {boolean} false: there is a fault, and nothing has changed */
  #open(content) {
    const fault = content.trim() === '' ? tr('There is nothing to open yet.') : this.app.open(content);
    this.#error.textContent = fault && sentence(fault);
    if (!fault) this.#dialog.close();
    return !fault;
  }

  async #chosen() {
    const chosen = this.#file.files?.[0];
    this.#file.value = ''; // so that the same file can be chosen again
    if (!chosen) return;
    const { text, fault } = await textOf(chosen);
    if (fault) this.#error.textContent = sentence(fault);
    else this.#open(text);
  }

  #closed() {
    if (this.#dialog.open) return; // the event came late, and the dialog is open again
    this.#gallery.hide();
    // In a folded menu the button that had the focus is hidden.
    if (document.activeElement === document.body) element('more').focus();
  }
}
