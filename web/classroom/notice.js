// SPDX-License-Identifier: MIT
// "Notice" waits until the goal is reached, or the reader gives it up.
import { tr } from '../languages/language.js';
import { progressOf, storeProgress } from './progress.js';

/** @param {string} lesson @returns {() => void} call when a goal is reached */
export function holdNotice(lesson) {
  const notice = document.getElementById('observations');
  const { seen, goals } = progressOf(lesson);
  if (!notice || seen || goals.length > 0 || !document.querySelector('.goal')) return () => {};
  const wait = document.createElement('p');
  wait.className = 'wait';
  const button = Object.assign(document.createElement('button'), { type: 'button', className: 'bordered', textContent: tr('Show it now') });
  wait.append(tr('First try to reach the goal.'), ' ', button);
  notice.before(wait);
  notice.classList.add('waiting'); // not hidden: it is printed
  const show = () => {
    notice.classList.remove('waiting');
    wait.remove();
  };
  button.addEventListener('click', () => {
    storeProgress(lesson, { seen: true });
    show();
    notice.tabIndex = -1;
    notice.focus();
  });
  return show;
}
