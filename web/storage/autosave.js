// SPDX-License-Identifier: MIT
// Protects the work from a crash, a closed tab or a reload. The browser stores the document while it is edited, and the
// next visit restores it, unless its address holds a link. A reload also restores Undo and the queue of searches. Pages
// inside other pages store nothing.
import { element, onClick } from '../browser/dom.js';
import { locale, tr, trSentence } from '../languages/language.js';
import { addOwnAddress, fingerprint, isOwnAddress } from './own_addresses.js';
import { removeWork, storeWork, keptWorks } from './kept_works.js';
import { remember, remembered } from '../browser/storage.js';

/** @typedef {import('../app/app.js').App} App */
/** @typedef {import('../page/commands.js').Command} Command */
/** @typedef {import('./kept_works.js').Work} Work */
/**
 * What the page's address says. text: of the example, if it was downloaded; arranged: it sets up the page; mode: of askedMode
 * @typedef {{example: string, text: string, arranged: boolean, mode: 'view' | 'edit' | '' | null}} FirstAddress
 */
/** @typedef {{id: string, address: string, before: string, link: string, visit?: string}} TabState  before: the last addresses before this one, separated by spaces; visit: of App.storeVisit */

const REST_MS = 2000;
const KEPT_ADDRESSES = 4;
const TAB_KEY = 'gaitsmith-here'; // state of this tab
const VIEWER_KEY = 'gaitsmith-viewer'; // set while this tab shows the viewer
const DISMISSED_KEY = 'gaitsmith-dismissed'; // works up to this time are not offered again

export class Autosave {
  #embedded = window.top !== window;
  #id = String(Math.random()).slice(2);
  #written = ''; // link of the document that this visit stored last
  #visit = ''; // fingerprint of Undo and the queue, as stored last
  #untouched = ''; // link of the first document, unless it continues earlier work
  #started = false;
  #warned = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;

  /** @param {App} app @param {import('../share/address.js').Address} address @param {import('../access/status_line.js').StatusLine} statusLine */
  constructor(app, address, statusLine) {
    this.app = app;
    this.address = address;
    this.statusLine = statusLine;
    if (this.#embedded) return;
    address.onWrite = () => {
      this.#storeTabState();
      addOwnAddress(location.hash.slice(1));
      remember(VIEWER_KEY, null, 'sessionStorage');
    };
    addEventListener('pagehide', () => this.save());
    addEventListener('visibilitychange', () => { if (document.hidden) this.save(); });
  }

  /**
   * Opens the visit's first document: this tab's work, else the link in the address, else the example that the address
   * names, else the last work, else a figure that cannot move yet. A page inside another page begins with a motion.
   * A link that this browser does not know opens in the viewer.
   * @param {FirstAddress} address
   */
  begin({ example, text, arranged, mode }) {
    const payload = location.hash.slice(1);
    const tabState = this.#embedded ? null : this.#tabState();
    const last = this.#embedded ? undefined : keptWorks()[0];
    // Firefox may reload an address that the page had replaced not long ago.
    const ownAddress = tabState?.address === payload || (arrival() === 'reload' && Boolean(tabState?.before.split(' ').includes(payload)));
    const continued = tabState !== null && ownAddress && tabState.link !== payload;
    const sameWork = continued || tabState?.link === payload;
    if (tabState && sameWork) this.#id = tabState.id;
    let opened = false;
    if (continued && this.app.open(tabState.link) === '') {
      this.address.follow();
      if (payload) this.address.changed();
    } else {
      opened = this.address.open();
      const named = () => (text ? this.app.open(text) === '' : example !== '' && this.app.begin(example));
      if (!payload && !named()) {
        if (last && this.app.open(last.link) === '') {
          this.statusLine.say(tr('Restored your last work: {1}. Choose New to start over.', last.title));
        } else if (!this.#embedded && !arranged) {
          this.app.begin();
        }
      }
    }
    this.app.forgetPast();
    const received = opened && !arranged && !this.#embedded && !sameWork && this.#arrives() && !isOwnAddress(payload)
      && keptWorks().every(({ link }) => link !== payload);
    if (mode === 'view' || (received && mode !== 'edit')) this.app.setViewing(true);
    else if (mode === 'edit' && opened) this.address.forgetEdit();
    if (this.#embedded) return;
    remember(VIEWER_KEY, this.app.viewing() ? 'on' : null, 'sessionStorage');
    if (opened && !this.app.viewing()) addOwnAddress(payload);
    if (sameWork && typeof tabState?.visit === 'string') this.app.restoreVisit(tabState.visit);
    this.#started = true;
    this.#written = this.app.link();
    this.#visit = fingerprint(this.app.storeVisit());
    if (!sameWork) this.#untouched = this.#written;
    if (continued || !payload) this.#storeTabState();
    if (payload && last && last.id !== this.#id && last.link !== this.#written
      && last.when > Number(remembered(DISMISSED_KEY))) this.#offer(last);
  }

  /** Whether the page comes to its address as a stranger would: by a link, or by a reload of the viewer. */
  #arrives() { return arrival() === 'navigate' || (arrival() === 'reload' && remembered(VIEWER_KEY, 'sessionStorage') !== null); }

  /**
   * Call after every change of the document. The first change is stored as soon as the code that made it returns, later
   * ones after a rest: a busy browser may end the page without 'pagehide', and before any timer.
   */
  changed() {
    if (!this.#started || this.#timer) return;
    queueMicrotask(() => {
      if (this.#started && this.save()) this.#timer ??= setTimeout(() => this.save(), REST_MS);
    });
  }

  /** @returns {boolean} whether there was anything to store */
  save() {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    if (!this.#started || this.app.viewing()) return false;
    const visit = this.app.storeVisit();
    const changed = fingerprint(visit) !== this.#visit;
    if (changed) this.#storeTabState(visit);
    // Store no work if the visit has changed nothing.
    if (!(this.app.canUndo() || this.app.canRedo())) return changed;
    const link = this.app.link();
    if (link === this.#written) return changed;
    this.#written = link;
    if (link === this.#untouched) {
      removeWork(this.#id); // all changes were undone
      return true;
    }
    const stored = storeWork({ id: this.#id, title: this.app.title(), link, when: Date.now() });
    this.#storeTabState(visit);
    if (!stored && !this.#warned) {
      this.#warned = true;
      this.statusLine.say(tr('This browser does not let the page keep your work: save it, or copy its link, before you leave.'));
    }
    return true;
  }

  /** Stops storing, because the application's data may be inconsistent. */
  end() {
    clearTimeout(this.#timer);
    this.#started = false;
  }

  /** Commands that open works of earlier visits. @returns {Command[]} */
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
      remember(DISMISSED_KEY, String(work.when));
      this.statusLine.say(tr('Your work is still kept. Open it from the list of commands.'));
    });
  }

  /** @param {Work} work */
  #open(work) {
    const fault = this.app.open(work.link);
    this.statusLine.say(fault ? tr('The kept work cannot be opened: {1}', trSentence(fault)) : tr('Opened {1}. Undo restores the previous version.', work.title));
  }

  #storeTabState(visit = this.app.storeVisit()) {
    const was = this.#tabState();
    const address = location.hash.slice(1);
    const before = was?.address === address ? was.before : [was?.address ?? '', ...(was?.before ?? '').split(' ')].slice(0, KEPT_ADDRESSES).join(' ');
    /** @type {TabState} */
    const tabState = { id: this.#id, address, before, link: this.app.link() };
    this.#visit = fingerprint(visit);
    // The document matters more than its past, which may be too long for the storage.
    if (!remember(TAB_KEY, JSON.stringify({ ...tabState, visit }), 'sessionStorage')) remember(TAB_KEY, JSON.stringify(tabState), 'sessionStorage');
  }

  /** @returns {TabState | null} */
  #tabState() {
    try {
      return JSON.parse(remembered(TAB_KEY, 'sessionStorage') ?? 'null');
    } catch {
      return null;
    }
  }
}

/** How this visit came to the page: 'navigate', 'reload' or 'back_forward'; undefined: unknown. */
function arrival() {
  const [visit] = performance.getEntriesByType('navigation');
  return visit instanceof PerformanceNavigationTiming ? visit.type : undefined;
}
