// SPDX-License-Identifier: MIT
// The wall's rows and tables as elements. What students wrote enters as text only.
import { tr, trSentence } from '../languages/language.js';

/** @typedef {import('./judge.js').Row} Row */
/** @typedef {import('./judge.js').Answer} Answer */

/** @param {string} tag @param {string} [text] @param {string} [kind]  class */
export function made(tag, text = '', kind = '') {
  const element = document.createElement(tag);
  element.textContent = text;
  if (kind) element.className = kind;
  return element;
}

/** @param {HTMLElement} parent @param {(Node | string)[]} children */
export function filled(parent, ...children) {
  parent.append(...children);
  return parent;
}

/** @param {Row} row @param {number} number  in order of arrival @param {number | undefined} same  number of an earlier row with this motion @param {string} site */
export function rowOf(row, number, same, site) {
  const work = made('td');
  if (row.motion) {
    const link = /** @type {HTMLAnchorElement} */ (made('a'));
    link.href = `${site}?view#${row.link}`;
    link.target = '_blank';
    link.ariaLabel = tr('Open the motion of number {1}', number);
    const canvas = made('canvas');
    canvas.ariaHidden = 'true';
    link.append(canvas);
    work.append(link);
  }
  if (row.fault) work.append(made('p', trSentence(row.fault), 'fault'));
  const goal = made('td');
  if (row.met !== null) goal.append(made('strong', row.met ? `✓ ${tr('reached')}` : `✗ ${tr('not reached')}`, row.met ? 'good' : 'bad'));
  for (const { text, met } of row.conditions) goal.append(made('p', `${met === null ? '·' : met ? '✓' : '✗'} ${text}`));
  const remarks = made('td');
  for (const word of row.changed) remarks.append(made('p', word, 'warned'));
  if (same !== undefined) remarks.append(made('p', tr('same motion as {1}', same), 'warned'));
  const written = made('td');
  for (const { question, given } of row.predictions.filter((each) => each.given)) written.append(filled(made('p'), made('small', `${tr('Predicted: {1}', question)} `), given));
  const right = row.answers.filter((answer) => answer.right).length;
  if (row.answers.length > 0) written.append(made('p', tr('{1} of {2} questions right', right, row.answers.length)));
  if (row.text) written.append(made('blockquote', row.text));
  const line = made('tr');
  line.append(filled(made('td'), String(number)), filled(made('th'), row.name || '–', ...row.lesson ? [made('small', row.lesson)] : []), work, goal, remarks, written);
  line.children[1].setAttribute('scope', 'row');
  return line;
}

/** For each question of each lesson: who gave which answer. @param {Row[]} rows @returns {HTMLElement[]} */
export function answerTables(rows) {
  /** @type {Map<string, {given: string, right: boolean | null, names: string[]}[]>} */
  const questions = new Map();
  rows.forEach((row, i) => {
    for (const { question, given, right } of [...row.predictions, ...row.answers]) {
      const answers = questions.get(question) ?? [];
      questions.set(question, answers);
      const words = given || tr('no answer');
      const same = answers.find((answer) => answer.given === words);
      const name = row.name || String(i + 1);
      if (same) same.names.push(name);
      else answers.push({ given: words, right, names: [name] });
    }
  });
  return [...questions].map(([question, answers]) => {
    const list = made('ul');
    for (const { given, right, names } of answers.sort((a, b) => b.names.length - a.names.length)) {
      list.append(filled(made('li'), made('strong', `${names.length} × `), given, ...right === null ? [] : [right ? ' ✓' : ' ✗'], ' ', made('small', names.join(', '))));
    }
    return filled(made('section'), made('h3', question), list);
  });
}

/** What was written, one under the other. @param {Row[]} rows @returns {HTMLElement[]} */
export function sentences(rows) {
  return rows.flatMap((row, i) => (row.text ? [filled(made('blockquote', row.text), made('small', ` ${row.name || i + 1}`))] : []));
}
