// SPDX-License-Identifier: MIT
// Shows on the book's first page what the reader has done: finished lessons and reached goals.
import { tr } from '../languages/language.js';
import { clearProgress, hasProgress, progressOf } from '../classroom/progress.js';

const note = document.getElementById('progress');
const lessons = /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('[data-lesson]'));

/** @param {HTMLElement} item  of a lesson @param {string[]} reached */
function showGoals(item, reached) {
  const words = item.querySelector('.reached span');
  if (!words) return;
  /** @type {string[]} */
  const goals = JSON.parse(item.dataset.goals ?? '[]');
  const met = goals.map((goal) => reached.includes(goal));
  for (const [i, ring] of item.querySelectorAll('.reached .tick').entries()) ring.classList.toggle('met', met[i]);
  const count = met.filter(Boolean).length;
  if (goals.length === 1) words.textContent = count ? tr('Goal reached') : tr('One goal');
  else words.textContent = count ? tr('{1} of {2} goals reached', count, goals.length) : tr('{1} goals', goals.length);
}

function mark() {
  for (const item of lessons) {
    item.querySelector('.done')?.remove();
    const { done: finished, goals } = progressOf(item.dataset.lesson ?? '');
    showGoals(item, goals);
    if (!finished) continue;
    const done = document.createElement('small');
    done.className = 'done';
    done.textContent = tr('done');
    item.querySelector('a')?.after(' ', done);
  }
  if (note) note.hidden = !hasProgress();
}

document.getElementById('forget')?.addEventListener('click', () => {
  clearProgress();
  mark();
});
addEventListener('pageshow', mark); // also after "Back" from a lesson
