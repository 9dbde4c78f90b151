// SPDX-License-Identifier: MIT
// Copy link, Save, and the clipboard's keys. All in DOM event handlers, because browsers allow access to
// clipboard and files only there.
import { element, offerFile, onClick, setText, toast } from '../browser/dom.js';
import { dialogs } from '../dialogs/dialogs.js';
import { grouped, tr, trSentence } from '../languages/language.js';

/** @typedef {import('../app/app.js').App} App */
/** @typedef {import('../access/status_line.js').StatusLine} StatusLine */

// Some programs cut links off after about 2,000 characters.
const LONG_LINK = 1900;

/** @param {App} app @param {import('./address.js').Address} address @param {StatusLine} statusLine */
export function startSharing(app, address, statusLine) {
  onClick('copy-link', () => void copy(app, address, statusLine));
  onClick('save', () => save(app, statusLine));
  startClipboardKeys(app, address, statusLine);
}

/** @param {App} app @param {import('./address.js').Address} address @param {StatusLine} statusLine */
async function copy(app, address, statusLine) {
  statusLine.say('');
  const link = address.link();
  try {
    await navigator.clipboard.writeText(link);
  } catch {
    // No permission, no focus, or no secure connection: the person can copy the link by hand.
    if (!await loaded(statusLine)) return;
    const text = element('link-text', HTMLTextAreaElement);
    text.value = link;
    setText(element('link-words'), link.length > LONG_LINK ? longWords(link) : '');
    element('link-dialog', HTMLDialogElement).showModal();
    text.select();
    return;
  }
  void confirmCopied(app, link, statusLine);
}

/** @param {StatusLine} statusLine @returns {Promise<boolean>} whether there are dialogs */
function loaded(statusLine) {
  return dialogs().then(() => true, () => {
    statusLine.say(tr('The dialog could not be loaded.'));
    return false;
  });
}

/** @param {string} link */
const longWords = ({ length }) => tr('This link has {1} characters. Some programs cut links off after about 2,000. A file always works.', grouped(length));

/** Warns if the link may be too long for some programs. @param {App} app @param {string} link @param {StatusLine} statusLine */
async function confirmCopied(app, link, statusLine) {
  if (link.length <= LONG_LINK) return toast(tr('Link copied'));
  if (!await loaded(statusLine)) return;
  element('long-link-save').onclick = () => {
    save(app, statusLine);
    element('long-link-dialog', HTMLDialogElement).close();
  };
  setText(element('long-link-words'), `${tr('Link copied')}. ${longWords(link)}`);
  element('long-link-dialog', HTMLDialogElement).showModal();
}

/** @param {App} app @param {StatusLine} statusLine */
function save(app, statusLine) {
  const name = `${fileName(app.title())}.json`;
  offerFile(name, app.documentText(), 'application/json');
  statusLine.say(tr('Saved as {1}', name));
}

/** A title as a file name, without extension. @param {string} title */
export const fileName = (title) => title.replace(/[^\p{L}\p{N}]+/gu, '-').replace(/^-+|-+$/g, '').toLowerCase() || 'gaitsmith';

/** @param {App} app @param {import('./address.js').Address} address @param {StatusLine} statusLine */
function startClipboardKeys(app, address, statusLine) {
  // Dialogs handle these keys themselves.
  const typing = () => document.querySelector('dialog[open]') !== null;
  addEventListener('copy', (event) => {
    if (typing() || !getSelection()?.isCollapsed) return;
    const link = address.link();
    event.clipboardData?.setData('text/plain', link);
    event.preventDefault();
    statusLine.say('');
    void confirmCopied(app, link, statusLine);
  });
  addEventListener('paste', (event) => {
    const text = event.clipboardData?.getData('text/plain') ?? '';
    if (typing() || text === '') return;
    event.preventDefault();
    const fault = app.open(text);
    if (fault) toast(tr('Not opened: {1}', trSentence(fault)));
  });
}
