// SPDX-License-Identifier: MIT
// Marks finished lessons on the book's first page.
import { clearProgress, hasProgress, progressOf } from './progress.js';

const note = document.getElementById('progress');
const lessons = /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('[data-lesson]'));

function mark() {
  for (const item of lessons) {
    item.querySelector('.done')?.remove();
    if (!progressOf(item.dataset.lesson ?? '').done) continue;
    const done = document.createElement('small');
    done.className = 'done';
    done.textContent = 'done';
    item.querySelector('a')?.after(' ', done);
  }
  if (note) note.hidden = !hasProgress();
}

document.getElementById('forget')?.addEventListener('click', () => {
  clearProgress();
  mark();
});
addEventListener('pageshow', mark); // also after "Back" from a lesson
