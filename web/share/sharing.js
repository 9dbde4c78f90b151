// SPDX-License-Identifier: MIT
// Copy link, Open, Save, and the clipboard's keys. All in DOM event handlers, because browsers allow access to
// clipboard and files only there.
import { element, offerFile, onClick, setText, toast } from '../browser/dom.js';
import { sentence } from './address.js';
import { grouped, tr, trSentence } from '../languages/language.js';

/** @typedef {import('../app/app.js').App} App */
/** @typedef {import('../access/status_line.js').StatusLine} StatusLine */

const MAX_BYTES = 8e6;
// Some programs cut links off after about 2,000 characters.
const LONG_LINK = 1900;

/** @param {App} app @param {import('./address.js').Address} address @param {StatusLine} statusLine */
export function startSharing(app, address, statusLine) {
  onClick('copy-link', () => copy(address, statusLine));
  onClick('save', () => save(app, statusLine));
  onClick('long-link-save', () => {
    save(app, statusLine);
    element('long-link-dialog', HTMLDialogElement).close();
  });
  startOpening(app);
  startClipboardKeys(app, address, statusLine);
}

/** @param {import('./address.js').Address} address @param {StatusLine} statusLine */
async function copy(address, statusLine) {
  statusLine.say('');
  const link = address.link();
  try {
    await navigator.clipboard.writeText(link);
  } catch {
    // No permission, no focus, or no secure connection: the person can copy the link by hand.
    const text = element('link-text', HTMLTextAreaElement);
    text.value = link;
    setText(element('link-words'), link.length > LONG_LINK ? longWords(link) : '');
    element('link-dialog', HTMLDialogElement).showModal();
    text.select();
    return;
  }
  confirmCopied(link);
}

/** @param {string} link */
const longWords = ({ length }) => tr('This link has {1} characters. Some programs cut links off after about 2,000. A file always works.', grouped(length));

/** Warns if the link may be too long for some programs. @param {string} link */
function confirmCopied(link) {
  if (link.length <= LONG_LINK) return toast(tr('Link copied'));
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

/** @param {App} app */
function startOpening(app) {
  const dialog = element('open-dialog', HTMLDialogElement);
  const text = element('open-text', HTMLTextAreaElement);
  const file = element('file', HTMLInputElement);
  const error = element('open-error');
  const open = (/** @type {string} */ content) => {
    const fault = content.trim() === '' ? tr('There is nothing to open yet.') : app.open(content);
    error.textContent = fault && sentence(fault);
    if (!fault) dialog.close();
  };

  onClick('open', () => {
    text.value = '';
    error.textContent = '';
    dialog.showModal();
    text.focus();
  });
  onClick('open-go', () => open(text.value));
  onClick('open-file', () => file.click());
  file.addEventListener('change', async () => {
    const chosen = file.files?.[0];
    file.value = ''; // so that the same file can be chosen again
    if (!chosen) return;
    const { text: content, fault } = await textOf(chosen);
    if (fault) error.textContent = sentence(fault);
    else open(content);
  });
  text.addEventListener('paste', () => setTimeout(() => open(text.value)));
}

/**
 * The text of a file. Rejects files that cannot be documents, because core's sentence about a picture would not help.
 * @param {File} file
 * @returns {Promise<{text: string, fault: string}>}
 */
export async function textOf(file) {
  const failure = (/** @type {string} */ fault) => ({ text: '', fault });
  if (file.size > MAX_BYTES) return failure(tr('it has {1} MB, which is too large for a Gaitsmith document', grouped(file.size / 1e6)));
  let text;
  try {
    text = new TextDecoder('utf-8', { fatal: true }).decode(await file.arrayBuffer());
  } catch {
    return failure(tr('it is not a Gaitsmith document (a file that Save made, or a text with a link)'));
  }
  return text.trim() === '' ? failure(tr('it is empty')) : { text, fault: '' };
}

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
    confirmCopied(link);
  });
  addEventListener('paste', (event) => {
    const text = event.clipboardData?.getData('text/plain') ?? '';
    if (typing() || text === '') return;
    event.preventDefault();
    const fault = app.open(text);
    if (fault) toast(tr('Not opened: {1}', trSentence(fault)));
  });
}
