// SPDX-License-Identifier: MIT
// Keeps what a reader predicts, chooses and writes in a lesson, in the browser, until it is handed in.
import { progressOf, storeProgress } from './progress.js';

/** @param {string} lesson */
export function keepAnswers(lesson) {
  const before = progressOf(lesson);
  for (const [key, kind] of /** @type {const} */ ([['predictions', 'predict'], ['answers', 'quiz']])) {
    document.querySelectorAll(`.${kind}`).forEach((box, i) => {
      restore(/** @type {HTMLElement} */ (box), before[key][i] ?? null);
      box.addEventListener('input', ({ target }) => {
        if (!(target instanceof HTMLInputElement)) return;
        const values = [...progressOf(lesson)[key]];
        while (values.length < i) values.push(null);
        values[i] = Number(target.value);
        showNumber(target);
        storeProgress(lesson, { [key]: values });
      });
    });
  }
  const field = document.getElementById('sentences');
  if (!(field instanceof HTMLTextAreaElement)) return;
  field.value = before.text;
  field.addEventListener('input', () => storeProgress(lesson, { text: field.value }));
}

/** @param {HTMLElement} box @param {number | null} value */
function restore(box, value) {
  if (value === null) return;
  const input = box.querySelector(`input[type="range"], input[value="${Number(value)}"]`);
  if (!(input instanceof HTMLInputElement)) return;
  if (input.type === 'range') input.value = String(value);
  else input.checked = true;
  showNumber(input);
  input.dispatchEvent(new Event('change', { bubbles: true }));
}

/** @param {HTMLInputElement} input */
function showNumber(input) {
  const shown = input.parentElement?.querySelector('output');
  if (shown) shown.textContent = `${input.value} ${input.dataset.unit ?? ''}`.trim();
}
