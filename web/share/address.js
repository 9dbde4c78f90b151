// SPDX-License-Identifier: MIT
// The document in the page's address. Its link follows '#', which browsers do not send to servers. The address is read
// at the start and when a person changes it. It is written when the document has not changed for a while.
import { banner } from '../browser/dom.js';
import { tr, trSentence } from '../languages/language.js';

/** @typedef {import('../app/app.js').App} App */

const REST_MS = 600;

export class Address {
  #followsDocument = false;
  /**
   * What the address held when it was opened, and that document's link as this page writes it. While that document is
   * open the address does not change, because it may hold the hash of a motion that looks different here.
   */
  #opened = { payload: '', link: '' };
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;
  /** Called when the address holds the current document. */
  onWrite = () => {};

  /** @param {App} app @param {() => boolean} busy  whether a search keeps changing the document */
  constructor(app, busy) {
    this.app = app;
    this.busy = busy;
    // The event's own address: the page may have written another one since the person changed it.
    addEventListener('hashchange', ({ newURL }) => this.open(new URL(newURL).hash.slice(1)));
  }

  /** The complete address of the current document. */
  link() { return this.linkOf(this.app.link()); }
  /** @param {string} payload */
  linkOf(payload) { return `${location.href.split(/[?#]/)[0]}#${payload}`; }

  /** Opens the link in the address, if there is one. A damaged link changes nothing. @param {string} [payload] @returns {boolean} whether it is open */
  open(payload = location.hash.slice(1)) {
    this.follow();
    if (payload === '' || payload === this.app.link()) return payload !== '';
    const fault = this.app.show(payload);
    if (!fault) this.#opened = { payload, link: this.app.link() };
    banner(fault && tr('This link was not opened: {1} Copy the whole link again. If a newer version made it, reload this page. The motion shown here is not the one in the link.', sentence(fault)));
    return !fault;
  }

  /** From now on the address follows the document. */
  follow() { this.#followsDocument = true; }

  /** Call after every change of the document. */
  changed() {
    if (!this.#followsDocument) return; // the first document needs no address
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => (this.busy() ? this.changed() : this.write()), REST_MS);
  }

  /** Stops changing the address. */
  end() {
    clearTimeout(this.#timer);
    this.#followsDocument = false;
  }

  /** Writes the current document into the address. In the viewer the address keeps what was received. */
  write() {
    if (this.app.viewing()) return;
    const { payload, link } = this.#opened;
    // The link says what is open from now on.
    if (replaceAddress(['open', 'view', 'edit'], this.app.link() === link ? payload : this.app.link())) this.onWrite();
  }

  /** Removes ?edit once the workbench is open, so that an address copied from there is an ordinary link. */
  forgetEdit() { replaceAddress(['edit'], location.hash.slice(1)); }
}

/** @param {string[]} without  these parameters @param {string} payload @returns {boolean} false: not allowed in a frame without an origin */
function replaceAddress(without, payload) {
  const target = new URL(location.href);
  for (const name of without) if (target.searchParams.has(name)) target.searchParams.delete(name);
  target.hash = payload;
  try {
    history.replaceState(null, '', target);
    return true;
  } catch {
    return false;
  }
}

/** Core's sentence in the page's language, with a full stop. @param {string} fault */
export function sentence(fault) {
  const words = trSentence(fault);
  return /[.!?]$/.test(words) ? words : `${words}.`;
}
