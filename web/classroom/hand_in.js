// SPDX-License-Identifier: MIT
// Hands in a lesson: a link, or a file, with the motion and what was predicted, answered and written.
import { tr } from '../languages/language.js';
import { copyField } from '../share/copying.js';
import { encodeWork, workFile } from '../share/work.js';
import { progressOf } from './progress.js';

/** @typedef {import('../share/work.js').Work} Work */

/** @param {string} id */
const find = (id) => /** @type {HTMLElement} */ (document.getElementById(id));

/** @param {string} lesson @param {() => Promise<string>} current  payload of the motion in the playground */
export function startHandIn(lesson, current) {
  const section = find('hand-in');
  const state = /** @type {HTMLElement} */ (section.querySelector('.state'));
  const link = /** @type {HTMLTextAreaElement} */ (find('hand-in-link'));
  section.hidden = false;

  /** @returns {Promise<Work>} */
  const work = async () => {
    const { predictions, answers, text, motion } = progressOf(lesson);
    const name = /** @type {HTMLInputElement} */ (find('hand-in-name')).value.trim();
    return { lesson, predictions, answers, text, name, motion: motion || await current().catch(() => '') };
  };
  find('hand-in-make').addEventListener('click', async () => {
    link.value = `${new URL('../wall.html', location.href).href}#${encodeWork(await work())}`;
    find('hand-in-made').hidden = false;
    state.textContent = missing(progressOf(lesson));
    link.focus();
    link.select();
  });
  find('hand-in-file').addEventListener('click', async () => {
    const address = URL.createObjectURL(new Blob([workFile(await work())], { type: 'application/json' }));
    Object.assign(document.createElement('a'), { href: address, download: `hand-in-${lesson}.json` }).click();
    setTimeout(() => URL.revokeObjectURL(address), 60000);
    state.textContent = missing(progressOf(lesson));
  });
  find('hand-in-copy').addEventListener('click', async () => { state.textContent = await copyField(link); });
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
