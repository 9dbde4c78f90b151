// SPDX-License-Identifier: MIT
// Nothing is lost by a crash, a closed tab or a reload: what this visit did is kept in the browser while it is done,
// and the next visit begins with it, unless its address holds a link. Pages inside other pages keep nothing.
import { element, onClick } from '../browser/dom.js';
import { locale, tr, trSentence } from '../languages/language.js';
import { forgetWork, keepWork, keptWorks } from './kept_works.js';
import { remember, remembered } from '../browser/storage.js';

/** @typedef {import('../app/app.js').App} App */
/** @typedef {import('../page/commands.js').Command} Command */
/** @typedef {import('./kept_works.js').Work} Work */

const REST_MS = 2000;
const HERE = 'gaitsmith-here';           // of this tab: what its address held, and what was open
const DISMISSED = 'gaitsmith-dismissed'; // works up to this time are not offered again

export class Autosave {
  #embedded = window.top !== window;
  #id = String(Math.random()).slice(2);
  #written = '';   // the link of what this visit kept last
  #untouched = ''; // and of what it began with, if nothing of that is its own
  #begun = false;
  #told = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;

  /** @param {App} app @param {import('../share/address.js').Address} address @param {import('../access/status_line.js').StatusLine} statusLine */
  constructor(app, address, statusLine) {
    this.app = app;
    this.address = address;
    this.statusLine = statusLine;
    if (this.#embedded) return;
    address.written = () => this.#noteHere();
    addEventListener('pagehide', () => this.save());
    addEventListener('visibilitychange', () => { if (document.hidden) this.save(); });
  }

  /** Opens what the visit begins with: this tab's own work, or what the address holds, or the last work there is. */
  begin() {
    const payload = location.hash.slice(1);
    const here = this.#embedded ? null : this.#here();
    const last = this.#embedded ? undefined : keptWorks()[0];
    const own = here?.address === payload && here.link !== payload;
    const again = own || here?.link === payload;
    if (here && again) this.#id = here.id;
    if (own && here && this.app.open(here.link) === '') {
      this.address.follow();
      if (payload) this.address.changed();
    } else {
      this.address.open();
      if (!payload && last && this.app.open(last.link) === '') {
        this.statusLine.say(tr('Your last work is back: {1}. New begins another.', last.title));
      }
    }
    this.app.forgetPast();
    if (this.#embedded) return;
    this.#begun = true;
    this.#written = this.app.link();
    if (!again) this.#untouched = this.#written;
    if (own || !payload) this.#noteHere();
    if (payload && last && last.id !== this.#id && last.link !== this.#written
      && last.when > Number(remembered(DISMISSED))) this.#offer(last);
  }

  /** The document is another one now, perhaps only for a moment. */
  changed() {
    if (!this.#begun) return;
    this.#timer ??= setTimeout(() => this.save(), REST_MS);
  }

  save() {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    // To look at something is not to work.
    if (!this.#begun || !(this.app.canUndo() || this.app.canRedo())) return;
    const link = this.app.link();
    if (link === this.#written) return;
    this.#written = link;
    if (link === this.#untouched) return forgetWork(this.#id); // all of it was undone
    const kept = keepWork({ id: this.#id, title: this.app.title(), link, when: Date.now() });
    this.#noteHere();
    if (kept || this.#told) return;
    this.#told = true;
    this.statusLine.say(tr('This browser does not let the page keep your work: save it, or copy its link, before you leave.'));
  }

  /** Stops storing: after this the application's data is not trusted. */
  end() {
    clearTimeout(this.#timer);
    this.#begun = false;
  }

  /** Works of earlier visits, to open. @returns {Command[]} */
  commands() {
    if (this.#embedded) return [];
    const time = (/** @type {number} */ when) =>
      new Date(when).toLocaleString(locale(), { month: 'short', day: 'numeric', hour: '2-digit', minute: '2-digit' });
    return keptWorks().filter(({ id }) => id !== this.#id).map((work) => ({
      id: `work/${work.id}`, group: 'Kept work', title: tr('Open kept work: {1}, {2}', work.title, time(work.when)), keys: [],
      run: () => this.#open(work),
    }));
  }

  /** @param {Work} work */
  #offer(work) {
    const row = element('kept');
    element('kept-title').textContent = work.title;
    row.hidden = false;
    onClick('kept-open', () => {
      row.hidden = true;
      this.#open(work);
    });
    onClick('kept-close', () => {
      row.hidden = true;
      remember(DISMISSED, String(work.when));
      this.statusLine.say(tr('It stays kept: the list of commands has it.'));
    });
  }

  /** @param {Work} work */
  #open(work) {
    const fault = this.app.open(work.link);
    this.statusLine.say(fault ? tr('The kept work cannot be opened: {1}', trSentence(fault)) : tr('Opened {1}. Undo brings back what was here.', work.title));
  }

  #noteHere() {
    const here = { id: this.#id, address: location.hash.slice(1), link: this.app.link() };
    remember(HERE, JSON.stringify(here), 'sessionStorage');
  }

  /** @returns {{id: string, address: string, link: string} | null} */
  #here() {
    try {
      return JSON.parse(remembered(HERE, 'sessionStorage') ?? 'null');
    } catch {
      return null;
    }
  }
}
