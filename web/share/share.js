// SPDX-License-Identifier: MIT
// The Share dialog: the link, its QR code, and the HTML that embeds the playground with this motion.
import { element, onClick, setText } from '../browser/dom.js';
import { panels } from '../catalogue/catalogue.js';
import { copyField } from './copying.js';
import { bookPage, followLanguage, grouped, tr } from '../languages/language.js';
import { locks } from './locks.js';

/** @typedef {import('../app/app.js').App} App */
/** @typedef {import('./address.js').Address} Address */

// At most 105 squares a side (version 22), for a camera across a room. A newcomer's first motion has a link of about 870.
const MAX_QR_LENGTH = 1000;
const QUIET = 4; // modules of margin, as the standard requires

/** @type {ShareDialog | null} */
let dialog = null;

/** Why a text is no goal, or ''. @typedef {(goal: string) => Promise<string>} GoalCheck */

/** @param {App} app @param {Address} address @param {GoalCheck} checkGoal */
export function openShare(app, address, checkGoal) {
  dialog ??= new ShareDialog(app, address, checkGoal);
  dialog.open();
}

/** A checkbox whose label follows the language. @param {{readonly name: string, readonly label: string}} part @param {boolean} defaultChecked */
function checkbox({ name, label }, defaultChecked) {
  const words = document.createTextNode('');
  followLanguage(() => { words.data = ` ${tr(label)}`; });
  const box = document.createElement('label');
  box.append(Object.assign(document.createElement('input'), { type: 'checkbox', value: name, defaultChecked }), words);
  return box;
}

class ShareDialog {
  #dialog = element('share-dialog', HTMLDialogElement);
  #link = element('share-link', HTMLTextAreaElement);
  #code = element('share-code');
  #words = element('share-words');
  #snippet = element('share-snippet', HTMLTextAreaElement);
  #panels = element('share-panels');
  #locks = element('share-locks');
  #goal = element('share-goal', HTMLInputElement);
  #task = element('share-task', HTMLTextAreaElement);
  #set = element('share-set', HTMLTextAreaElement);
  /** The link of the QR code. */
  #drawn = '';
  #height = element('share-height', HTMLInputElement);

  /** @param {App} app @param {Address} address @param {GoalCheck} checkGoal */
  constructor(app, address, checkGoal) {
    this.app = app;
    this.address = address;
    this.checkGoal = checkGoal;
    for (const panel of panels) this.#panels.append(checkbox(panel, true));
    for (const part of locks) this.#locks.append(checkbox(part, false));
    for (const field of [this.#panels, this.#locks, this.#height, this.#goal, this.#task]) field.addEventListener('input', () => this.#write());
    this.#goal.addEventListener('change', () => void this.#check());
    for (const field of [this.#link, this.#snippet, this.#set]) field.addEventListener('focus', () => field.select());
    onClick('share-larger', () => this.#dialog.classList.toggle('large'));
    onClick('share-copy', () => void this.#copy(this.#link));
    onClick('share-send', () => void this.#send());
    element('share-send').hidden = !('share' in navigator);
    onClick('share-copy-snippet', () => void this.#copy(this.#snippet));
    onClick('share-copy-set', () => void this.#copy(this.#set));
    onClick('share-scorm', () => void this.#save());
  }

  open() {
    this.#link.value = this.address.link();
    this.#write();
    this.#dialog.classList.remove('large');
    setText(element('share-said'), '');
    this.#dialog.showModal();
    this.#link.scrollTop = 0;
    element('share-copy').focus();
  }

  async #draw() {
    const link = this.#drawn;
    this.#code.hidden = element('share-larger').hidden = link.length > MAX_QR_LENGTH;
    setText(this.#words, link.length > MAX_QR_LENGTH
      ? tr('This link is too long for a QR code that cameras read across a room: {1} characters, and at most {2} fit. Fewer rules or a timer make it shorter.', grouped(link.length), grouped(MAX_QR_LENGTH))
      : tr('Scan with a phone. The code holds the whole motion.'));
    if (this.#code.hidden) return;
    const { encode } = await import('./uqr.js').catch(() => ({ encode: null }));
    if (!encode) return setText(this.#words, tr('The code could not be loaded.'));
    const { data, size } = encode(link, { ecc: 'L', border: QUIET });
    // One path with a square for each dark module.
    const path = data.flatMap((row, y) => row.flatMap((dark, x) => (dark ? `M${x} ${y}h1v1h-1z` : []))).join('');
    const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
    svg.setAttribute('viewBox', `0 0 ${size} ${size}`);
    svg.setAttribute('role', 'img');
    svg.setAttribute('aria-label', tr('QR code of the link'));
    const squares = document.createElementNS(svg.namespaceURI, 'path');
    squares.setAttribute('d', path);
    svg.append(squares);
    this.#code.replaceChildren(svg);
  }

  /** Writes the link and the HTML for embedding, with the chosen options. */
  #write() {
    const chosen = (/** @type {HTMLElement} */ group) => [...group.querySelectorAll('input')].filter(({ checked }) => checked).map(({ value }) => value);
    const shown = chosen(this.#panels), locked = chosen(this.#locks), goal = this.#goal.value.replaceAll(' ', ''), task = this.#task.value.trim();
    const address = new URL(this.#link.value);
    address.search = '';
    if (shown.length < panels.length) address.searchParams.set('panels', shown.join(',') || 'none');
    if (locked.length > 0) address.searchParams.set('lock', locked.join(','));
    if (goal) address.searchParams.set('goal', goal);
    if (task) address.searchParams.set('task', task);
    const source = address.href.replaceAll('%2C', ',');
    this.#set.value = address.search ? source : `${source.split('#')[0]}?edit#${source.split('#')[1]}`;
    // The code leads to the assignment, if there is one.
    const drawn = goal || task || locked.length > 0 ? source : this.#link.value;
    if (drawn !== this.#drawn) {
      this.#drawn = drawn;
      void this.#draw();
    }
    const wall = new URL(`../${bookPage('wall.html')}`, import.meta.url);
    if (goal) wall.searchParams.set('goal', goal);
    element('share-wall', HTMLAnchorElement).href = wall.href;
    const height = Math.min(2000, Math.max(300, Number(this.#height.value) || 600));
    this.#snippet.value = `<iframe src="${escaped(source)}"\n  title="${escaped(this.app.title() || 'Gaitsmith')}" width="100%" height="${height}"\n  allow="clipboard-write; fullscreen" style="border:0"></iframe>`;
  }

  async #check() {
    const fault = this.#goal.value.trim() === '' ? '' : await this.checkGoal(this.#goal.value);
    setText(element('share-goal-fault'), fault);
    this.#goal.setAttribute('aria-invalid', String(fault !== ''));
  }

  /** Saves a SCORM package, whose goal decides when it is passed. */
  async #save() {
    const said = element('share-scorm-said');
    await this.#check();
    if (this.#goal.value.trim() === '' || this.#goal.getAttribute('aria-invalid') === 'true') {
      setText(said, tr('A package needs a goal above, because it reports when the goal is reached.'));
      return this.#goal.focus();
    }
    try {
      const { saveScormPackage } = await import('./share_scorm.js');
      await saveScormPackage(this.#set.value, this.app.title() || 'Gaitsmith');
    } catch {
      setText(said, tr('A part of the page could not be loaded. Reload the page, and try again.'));
    }
  }

  /** Offers the link to the device's other apps, as phones do. */
  async #send() {
    setText(element('share-said'), '');
    try {
      await navigator.share({ title: this.app.title() || 'Gaitsmith', url: this.#link.value });
    } catch (error) {
      if (error instanceof DOMException && error.name === 'AbortError') return; // the person has changed their mind
      setText(element('share-said'), tr('The link could not be sent from here. Copy it instead.'));
    }
  }

  /** @param {HTMLTextAreaElement} field */
  async #copy(field) { setText(element('share-said'), await copyField(field)); }
}

/** Escapes text for an attribute in double quotes. @param {string} text */
const escaped = (text) => text.replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
