// SPDX-License-Identifier: MIT
// The dialog that hands in an assignment: a link for the wall, with the shown motion and what was written.
import { element, onClick, setText } from '../browser/dom.js';
import { bookPage } from '../languages/language.js';
import { copyField } from '../share/copying.js';
import { emptyWork, encodeWork } from '../share/work.js';

/** @type {(() => string) | null} */
let current = null;

/** What keeps the sentences. @typedef {{text: string, onText: () => void}} Keeper */
/** @type {Keeper | null} */
let keeper = null;

/** @param {() => string} link  of the shown motion @param {Keeper | null} [keep] */
export function openHandIn(link, keep = null) {
  const first = current === null;
  current = link;
  keeper = keep;
  if (first) begin();
  if (keeper) element('work-text', HTMLTextAreaElement).value = keeper.text;
  setText(element('work-said'), '');
  write();
  element('work-dialog', HTMLDialogElement).showModal();
  element('work-text').focus();
}

function begin() {
  for (const id of ['work-text', 'work-name']) element(id).addEventListener('input', write);
  const link = element('work-link', HTMLTextAreaElement);
  link.addEventListener('focus', () => link.select());
  element('work-text').addEventListener('input', () => {
    if (!keeper) return;
    keeper.text = element('work-text', HTMLTextAreaElement).value.trim();
    keeper.onText();
  });
  onClick('work-copy', async () => setText(element('work-said'), await copyField(link)));
}

function write() {
  const work = {
    ...emptyWork(),
    text: element('work-text', HTMLTextAreaElement).value.trim(),
    name: element('work-name', HTMLInputElement).value.trim(),
    motion: current?.().split('#')[1] ?? '',
  };
  element('work-link', HTMLTextAreaElement).value = `${new URL(`../${bookPage('wall.html')}`, import.meta.url).href}#${encodeWork(work)}`;
}
