// SPDX-License-Identifier: MIT
// The dialog that hands in an assignment: a link for the wall, with the shown motion and what was written.
import { element, onClick, setText } from '../browser/dom.js';
import { tr } from '../languages/language.js';
import { emptyWork, encodeWork } from '../share/work.js';

/** @type {(() => string) | null} */
let current = null;

/** @param {() => string} link  of the shown motion */
export function openHandIn(link) {
  const first = current === null;
  current = link;
  if (first) begin();
  setText(element('work-said'), '');
  write();
  element('work-dialog', HTMLDialogElement).showModal();
  element('work-text').focus();
}

function begin() {
  for (const id of ['work-text', 'work-name']) element(id).addEventListener('input', write);
  const link = element('work-link', HTMLTextAreaElement);
  link.addEventListener('focus', () => link.select());
  onClick('work-copy', async () => {
    try {
      await navigator.clipboard.writeText(link.value);
      setText(element('work-said'), tr('Copied'));
    } catch {
      link.select(); // the person copies by hand
      setText(element('work-said'), tr('The browser did not allow copying by itself. The text is selected: press Ctrl+C or ⌘C.'));
    }
  });
}

function write() {
  const work = {
    ...emptyWork(),
    text: element('work-text', HTMLTextAreaElement).value.trim(),
    name: element('work-name', HTMLInputElement).value.trim(),
    motion: current?.().split('#')[1] ?? '',
  };
  element('work-link', HTMLTextAreaElement).value = `${new URL('../book/wall.html', import.meta.url).href}#${encodeWork(work)}`;
}
