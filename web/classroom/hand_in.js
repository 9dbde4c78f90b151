// SPDX-License-Identifier: MIT
// The section "Hand in" of a page: a link, or a file, with what a student did there.
import { bookPage, tr } from '../languages/language.js';
import { copyField } from '../share/copying.js';
import { emptyWork, encodeWork, workFile } from '../share/work.js';
import { progressOf } from './progress.js';

/** @typedef {import('../share/work.js').Work} Work */

/** @param {string} id */
const find = (id) => /** @type {HTMLElement} */ (document.getElementById(id));

/** @param {string} name  of the file, without ending @param {() => Promise<Work>} made  without a name @param {() => string} remark  after it is made */
export function startHandIn(name, made, remark) {
  const section = find('hand-in');
  const state = /** @type {HTMLElement} */ (section.querySelector('.state'));
  const link = /** @type {HTMLTextAreaElement} */ (find('hand-in-link'));

  const work = async () => ({ ...await made(), name: /** @type {HTMLInputElement} */ (find('hand-in-name')).value.trim() });
  find('hand-in-make').addEventListener('click', async () => {
    link.value = `${new URL(`../${bookPage('wall.html')}`, import.meta.url).href}#${encodeWork(await work())}`;
    find('hand-in-made').hidden = false;
    state.textContent = remark();
    link.focus();
    link.select();
  });
  find('hand-in-file').addEventListener('click', async () => {
    const address = URL.createObjectURL(new Blob([workFile(await work())], { type: 'application/json' }));
    Object.assign(document.createElement('a'), { href: address, download: `${name}.json` }).click();
    setTimeout(() => URL.revokeObjectURL(address), 60000);
    state.textContent = remark();
  });
  find('hand-in-copy').addEventListener('click', async () => { state.textContent = await copyField(link); });
}

/** @param {string} lesson @param {() => Promise<string>} current  payload of the motion in the playground */
export function startLessonHandIn(lesson, current) {
  find('hand-in').hidden = false;
  startHandIn(`hand-in-${lesson}`, async () => {
    const { predictions, answers, text, motion } = progressOf(lesson);
    return { ...emptyWork(), lesson, predictions, answers, text, motion: motion || await current().catch(() => '') };
  }, () => missing(progressOf(lesson)));
}

/** What is not done yet. @param {import('./progress.js').Done} done */
function missing({ goals, predictions, answers, text }) {
  const count = (/** @type {string} */ kind) => document.querySelectorAll(`.${kind}`).length;
  const given = (/** @type {(number | null)[]} */ values) => values.filter((value) => value !== null && value !== undefined).length;
  const parts = [
    goals.length < count('goal') && tr('the goal is not reached'),
    given(predictions) < count('predict') && tr('no prediction'),
    given(answers) < count('quiz') && tr('questions are open'),
    text.trim() === '' && tr('no sentences'),
  ].filter(Boolean);
  return parts.length === 0 ? tr('Complete.') : tr('Still missing: {1}.', parts.join(', '));
}
