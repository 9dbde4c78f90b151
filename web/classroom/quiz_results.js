// SPDX-License-Identifier: MIT
// What a class answered before and after the lessons: in pairs, by question, and as a table for spreadsheets.
import { csvOfCells } from './table.js';

/** @typedef {import('./questions.js').Asked} Asked */
/** @typedef {import('../share/work.js').Quiz} Quiz */
/** @typedef {(number | null)[] | null} Round */
/** @typedef {{name: string, before: Round, after: Round}} Pupil */
/**
 * Of one question. choices: how often each answer was given, the last one is "I do not know"; of those with both rounds: kept: right
 * twice; gained, lost: right only then; neither
 * @typedef {{before: {answered: number, right: number, choices: number[]}, after: {answered: number, right: number, choices: number[]}, both: number, kept: number, gained: number, lost: number, neither: number}} Counted
 */

/**
 * The rounds of each pupil. Two results with the same name are one pupil's; of two results of the same round the later counts. Those without a
 * name are a pupil each, unless all answers are those of an earlier one with both rounds: then the same link came twice.
 * @param {{name: string, quiz: Quiz}[]} results  in order of arrival
 */
export function pupils(results) {
  /** @type {Pupil[]} */
  const found = [];
  /** @type {Map<string, Pupil>} */
  const byName = new Map();
  let repeated = 0;
  for (const { name, quiz: { before, after } } of results) {
    const key = name.trim().toLowerCase().replace(/\s+/g, ' ');
    const known = key === '' ? found.find((one) => one.name === '' && before && after && JSON.stringify([one.before, one.after]) === JSON.stringify([before, after])) : byName.get(key);
    if (known) {
      if ((known.before && before) || (known.after && after)) repeated++;
      known.before = before ?? known.before;
      known.after = after ?? known.after;
      continue;
    }
    const pupil = { name: name.trim(), before, after };
    found.push(pupil);
    if (key !== '') byName.set(key, pupil);
  }
  return { pupils: found, repeated };
}

/** @param {Pupil[]} class_ @param {Asked[]} questions @returns {Counted[]} */
export function counted(class_, questions) {
  return questions.map(({ answers, right }, i) => {
    const of = (/** @type {'before' | 'after'} */ round) => {
      const given = class_.flatMap((pupil) => (pupil[round] ? [pupil[round][i] ?? null] : []));
      return { answered: given.length, right: given.filter((one) => one === right).length, choices: [...answers, ''].map((_, k) => given.filter((one) => one === k).length) };
    };
    const pairs = class_.flatMap(({ before, after }) => (before && after ? [[before[i] === right, after[i] === right]] : []));
    const count = (/** @type {boolean} */ first, /** @type {boolean} */ second) => pairs.filter(([one, two]) => one === first && two === second).length;
    return { before: of('before'), after: of('after'), both: pairs.length, kept: count(true, true), gained: count(false, true), lost: count(true, false), neither: count(false, false) };
  });
}

/** @param {Round} round @param {Asked[]} questions @returns {number | null} */
export const points = (round, questions) => (round === null ? null : questions.filter(({ right }, i) => round[i] === right).length);

/** "c"; "?": I do not know; "": none, or no answer of this question. @param {number | null | undefined} given @param {Asked} question */
const letter = (given, { answers }) => (given === null || given === undefined || given > answers.length ? '' : given === answers.length ? '?' : String.fromCharCode(97 + given));

/** @param {Pupil[]} class_ @param {Asked[]} questions @param {string} set @returns {string} a row for each pupil */
export function quizCsv(class_, questions, set) {
  const numbered = (/** @type {string} */ name) => questions.map((_, i) => `${name}_${i + 1}`);
  const head = ['number', 'name', 'questions', ...numbered('before'), ...numbered('after'), 'before_right', 'after_right'];
  const rows = class_.map(({ name, before, after }, i) => [
    i + 1, name, set, ...questions.map((question, k) => letter(before?.[k], question)), ...questions.map((question, k) => letter(after?.[k], question)),
    points(before, questions) ?? '', points(after, questions) ?? '',
  ]);
  return csvOfCells([head, ...rows]);
}
