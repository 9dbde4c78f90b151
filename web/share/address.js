// SPDX-License-Identifier: MIT
// The document in the page's address: its link stands after '#', where no server sees it. Read at the start and
// whenever it is changed by hand; written when the document has come to rest.
import { banner } from '../browser/dom.js';
import { tr, trSentence } from '../languages/language.js';

/** @typedef {import('../app/app.js').App} App */

const REST_MS = 600;

export class Address {
  #read = false;
  /**
   * What the address held when it was opened, and that document's link as it is written here. While it is the
   * present document the address stays as it was: it may hold the hash of a motion that looks different here.
   */
  #opened = { payload: '', link: '' };
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;
  /** Called when the address holds the present document. */
  written = () => {};

  /** @param {App} app @param {() => boolean} busy  a search changes the document over and over */
  constructor(app, busy) {
    this.app = app;
    this.busy = busy;
    addEventListener('hashchange', () => this.open());
  }

  /** The whole address of the present document. */
  link() { return this.linkOf(this.app.link()); }
  /** @param {string} payload */
  linkOf(payload) { return `${location.href.split(/[?#]/)[0]}#${payload}`; }

  /** Opens what the address holds, if anything. A damaged link leaves the present work as it is. */
  open() {
    this.follow();
    const payload = location.hash.slice(1);
    if (payload === '' || payload === this.app.link()) return;
    const fault = this.app.open(payload);
    if (!fault) this.#opened = { payload, link: this.app.link() };
    banner(fault && tr('This link was not opened: {1} Copy the whole link again, or reload this page in case a newer one made it; what is shown here is not what the link held.', sentence(fault)));
  }

  /** From now on the address follows the document. */
  follow() { this.#read = true; }

  /** The document is another one now. */
  changed() {
    if (!this.#read) return; // the document the page begins with has no need of an address
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => (this.busy() ? this.changed() : this.write()), REST_MS);
  }

  /** It stays as it is. */
  end() {
    clearTimeout(this.#timer);
    this.#read = false;
  }

  write() {
    const { payload, link } = this.#opened;
    try {
      history.replaceState(null, '', `#${this.app.link() === link ? payload : this.app.link()}`);
    } catch {
      return; // a frame without an origin may not
    }
    this.written();
  }
}

/** Core's sentence for the reader, with a full stop. @param {string} fault */
export function sentence(fault) {
  const words = trSentence(fault);
  return /[.!?]$/.test(words) ? words : `${words}.`;
}
