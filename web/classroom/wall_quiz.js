// SPDX-License-Identifier: MIT
// The wall's part about the questions before and after the lessons.
import { fixed, tr } from '../languages/language.js';
import { counted, points, pupils, quizCsv } from './quiz_results.js';
import { QUESTIONS, SET, UNKNOWN } from './questions.js';
import { filled, made } from './wall_rows.js';

/** @typedef {import('../share/work.js').Work} Work */

const section = /** @type {HTMLElement} */ (document.getElementById('wall-quiz'));
/** @type {import('./quiz_results.js').Pupil[]} */
let class_ = [];

/** Shows the results, and says how many there are. @param {Work[]} works  with a quiz */
export function showQuiz(works) {
  section.hidden = works.length === 0;
  const known = works.flatMap(({ name, quiz }) => (quiz?.set === SET ? [{ name, quiz }] : []));
  const result = pupils(known);
  class_ = result.pupils;
  if (works.length === 0) return '';
  const both = class_.filter(({ before, after }) => before && after).length;
  const others = works.length - known.length;
  const summary = [
    class_.length === 1 ? tr('1 student, {1} with both rounds.', both) : tr('{1} students, {2} with both rounds.', class_.length, both),
    result.repeated > 0 && tr('{1} sent a round again: the later answers count.', result.repeated),
    others > 0 && tr('{1} answered other questions than these and are left out.', others),
    both > 0 && tr('Those with both rounds had {1} of {2} right before, on average, and {3} after.', mean('before'), QUESTIONS.length, mean('after')),
    tr('The numbers do not say why something has changed.'),
  ].filter(Boolean).join(' ');
  /** @type {HTMLElement} */ (section.querySelector('p')).textContent = summary;
  /** @type {HTMLElement} */ (section.querySelector('tbody')).replaceChildren(...counted(class_, QUESTIONS).map(rowOf));
  return works.length === 1 ? tr('1 result of the questions before and after.') : tr('{1} results of the questions before and after.', works.length);
}

/** @param {'before' | 'after'} round */
function mean(round) {
  const sums = class_.filter(({ before, after }) => before && after).map((pupil) => points(pupil[round], QUESTIONS) ?? 0);
  return fixed(sums.reduce((sum, each) => sum + each, 0) / sums.length, 1);
}

/** @param {import('./quiz_results.js').Counted} counts @param {number} i */
function rowOf({ before, after, both, gained, lost, kept, neither }, i) {
  const { question, answers, right } = QUESTIONS[i];
  const share = (/** @type {{answered: number, right: number}} */ round) => made('td', round.answered === 0 ? '–' : tr('{1} of {2}', round.right, round.answered));
  const list = made('ul');
  [...answers, UNKNOWN].forEach((words, k) => list.append(made('li', `${k === right ? '✓ ' : ''}${tr(words)} ${before.choices[k]} → ${after.choices[k]}`)));
  const details = filled(made('details'), made('summary', `${i + 1}. ${tr(question)}`), list);
  const cells = [share(before), share(after), ...[gained, lost, kept, neither].map((count) => made('td', both === 0 ? '–' : String(count)))];
  const head = filled(made('th'), details);
  head.setAttribute('scope', 'row');
  return filled(made('tr'), head, ...cells);
}

document.getElementById('wall-quiz-csv')?.addEventListener('click', () => {
  const address = URL.createObjectURL(new Blob(['\ufeff', quizCsv(class_, QUESTIONS, SET)], { type: 'text/csv' }));
  Object.assign(document.createElement('a'), { href: address, download: 'before-and-after.csv' }).click();
  setTimeout(() => URL.revokeObjectURL(address), 60000);
});
