// SPDX-License-Identifier: MIT
// A file or a link dropped on the page. A hint during the drag shows what will happen.
import { banner, element } from '../browser/dom.js';
import { textOf } from './file_text.js';
import { sentence } from './address.js';
import { tr } from '../languages/language.js';

/** @typedef {import('../app/app.js').App} App */

/** @param {App} app */
export function startDropping(app) {
  const hint = element('drop-hint');
  const fits = (/** @type {DragEvent} */ event) => event.dataTransfer?.types.some((type) => type === 'Files' || type === 'text/plain') ?? false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let gone;
  const hide = () => {
    clearTimeout(gone);
    hint.hidden = true;
  };
  addEventListener('dragover', (event) => {
    if (!fits(event) || document.querySelector('dialog[open]')) return;
    event.preventDefault();
    hint.hidden = false;
    // 'dragover' repeats while the pointer is over the page. 'dragleave' is unreliable.
    clearTimeout(gone);
    gone = setTimeout(hide, 700);
  });
  addEventListener('dragleave', (event) => { if (event.relatedTarget === null) hide(); });
  addEventListener('drop', async (event) => {
    hide();
    if (!fits(event)) return;
    event.preventDefault();
    const { files } = /** @type {DataTransfer} */ (event.dataTransfer);
    const dropped = event.dataTransfer?.getData('text/plain') ?? '';
    if (files.length > 1) return banner(tr('These files were not opened: a page shows one document, so drop one file at a time.'));
    if (files.length === 0) {
      const fault = app.open(dropped);
      return banner(fault && tr('What you dropped was not opened: {1}', sentence(fault)));
    }
    const { text, fault } = await textOf(files[0]);
    const wrong = fault || app.open(text);
    banner(wrong && tr('“{1}” was not opened: {2} What was here is unchanged.', files[0].name, sentence(wrong)));
  });
}
